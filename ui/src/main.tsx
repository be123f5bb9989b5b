import { render } from "preact";
import "./design/fonts.css";
import "./design/tokens.css";
import "./design/base.css";
import "./design/controls.css";
import { askForFirstProgram } from "./app/first_program";
import { open } from "./app/session";
import { App } from "./screens/App";
import { loadEditor } from "./screens/editor_loader";

const root = document.getElementById("app");
if (root) render(<App />, root);

askForFirstProgram();
// The window's self-check and the benchmarks wait for this: the page answers, and its editor is there.
void Promise.all([open(), loadEditor()]).then(() => {
  document.documentElement.dataset.ready = "true";
});
