/*
 * The style sheets of what the start shows, in the one order that the built page has too; those of all other parts stand
 * in styles_later.ts. Were each part to bring its own along, what is fetched later would come after what was fetched
 * before, and one screen would look different after another.
 * What a later sheet says about an element wins over an earlier one: what others build on stands first.
 */
import "./design/fonts.css";
import "./design/tokens.css";
import "./design/base.css";
import "./design/controls.css";
import "./screens/header.css";
import "./screens/pictures.css";
import "./screens/start.css";
import "./editor/editor.css";
import "./editor/reader.css";
import "./debug/debug.css";
import "./scene/scene.css";
import "./run/run.css";
import "./run/text/text.css";
import "./plots/plots.css";
import "./screens/studio.css";
