import "./app/ask_first";
import "./app/known_language";
import { render } from "preact";
import "./styles";
import { firstAnswers } from "./app/first_answers";
import { open } from "./app/session";
import { App } from "./screens/App";

/** A server that is slow to answer is worth a frame around what is to come. */
const PATIENCE_MS = 300;

const patience = new Promise((resolve) => setTimeout(resolve, PATIENCE_MS));
const opened = open();
const root = document.getElementById("app");

// Otherwise drawn once, with everything in its place.
void Promise.race([firstAnswers(), patience]).then(() => {
  if (root) render(<App />, root);
});

// The window's self-check and the benchmarks wait for this: the page answers, and its editor is there.
void opened.then(() => {
  document.documentElement.dataset.ready = "true";
});
