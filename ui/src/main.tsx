import { render } from "preact";
import "./design/fonts.css";
import "./design/tokens.css";
import "./design/base.css";
import "./design/controls.css";
import { open } from "./app/session";
import { App } from "./screens/App";
import { loadEditor } from "./screens/editor_loader";

const root = document.getElementById("app");
if (root) render(<App />, root);
void open();
void loadEditor();
