import { render } from "preact";
import "./design/fonts.css";
import "./design/tokens.css";
import "./design/base.css";
import "./design/controls.css";
import "./editor/editor.css"; // here, so that the editor's code waits for no style sheet of its own
import { askForFirstProgram } from "./app/first_program";
import { open } from "./app/session";
import { App } from "./screens/App";
import { loadEditor } from "./screens/editor_loader";

// What takes time is begun before anything is drawn.
askForFirstProgram();
const ready = Promise.all([open(), loadEditor()]);

const root = document.getElementById("app");
if (root) render(<App />, root);

// The window's self-check and the benchmarks wait for this: the page answers, and its editor is there.
void ready.then(() => {
  document.documentElement.dataset.ready = "true";
});
