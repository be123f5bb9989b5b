import "./shell/ask_first";
import "./shell/known_language";
import { render } from "preact";
import "./styles";
import { App } from "./frame/App";
import "./frame/prefetch";
import * as camera from "./camera/sight";
import { fetchTexts, language } from "./i18n";
import { receive, resync } from "./run/live";
import { receiveState } from "./run/real/robot_state";
import { firstRequestsSettled } from "./shell/first_answers";
import { setLazyStyles } from "./shell/lazy";
import { open } from "./shell/session";

/** A server that is slow to answer is worth a frame around what is to come. */
const FIRST_RENDER_TIMEOUT_MS = 300;

setLazyStyles(() => import("./styles_lazy"));

const renderTimeout = new Promise((resolve) => setTimeout(resolve, FIRST_RENDER_TIMEOUT_MS));
const texts = fetchTexts(language.peek());
const opened = texts.then(() => open({ receive, resync }, camera, receiveState));
const root = document.getElementById("app");

// Otherwise drawn once, with everything in its place.
void Promise.all([texts, Promise.race([firstRequestsSettled(), renderTimeout])]).then(() => {
  if (root) render(<App />, root);
});

// The window's self-check and the benchmarks wait for this: the page answers, and its editor is there.
void opened.then(() => {
  document.documentElement.dataset.ready = "true";
});
