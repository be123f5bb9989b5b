/*
 * Style sheets of the first bundle, in the order of the built page; styles_lazy.ts has all others.
 * No part imports its own sheet: lazy sheets would then apply in the order of loading, and a screen
 * would look different after another screen. If two sheets style an element, the later one wins, so
 * shared sheets come first.
 */
import "./kit/fonts.css";
import "./kit/tokens.css";
import "./kit/base.css";
import "./kit/layout.css";
import "./kit/controls.css";
import "./frame/header/header.css";
import "./frame/header/real_robot.css";
import "./run/real/real.css";
import "./kit/pictures/pictures.css";
import "./work/livery/livery.css";
import "./start/start.css";
import "./editor/editor.css";
import "./editor/reader/reader.css";
import "./studio/debug/debug.css";
import "./scene/scene.css";
import "./run/panels/run.css";
import "./studio/cloud/cloud.css";
import "./studio/text/text.css";
import "./plots/plots.css";
import "./studio/studio.css";
