/*
 * The style sheets of what the start shows, in the one order that the built page has too; those of all other parts stand
 * in styles_lazy.ts. Were each part to bring its own along, what is fetched later would come after what was fetched
 * before, and one screen would look different after another.
 * What a later sheet says about an element wins over an earlier one: what others build on stands first.
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
import "./start/start.css";
import "./editor/editor.css";
import "./editor/reader/reader.css";
import "./studio/debug/debug.css";
import "./scene/scene.css";
import "./run/panels/run.css";
import "./studio/text/text.css";
import "./plots/plots.css";
import "./studio/studio.css";
