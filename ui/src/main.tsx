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
import { receiveTruthSource } from "./run/real/truth_sources";
import { firstRequestsSettled } from "./shell/first_answers";
import { setLazyStyles } from "./shell/lazy";
import { open } from "./shell/session";

/** If the server answers later than this, the page draws its frame without contents first. */
const FIRST_RENDER_TIMEOUT_MS = 300;

setLazyStyles(() => import("./styles_lazy"));

const receiveOfRobot: Parameters<typeof open>[2] = (event) =>
  event.type === "robot_state" ? receiveState(event) : receiveTruthSource(event);

const renderTimeout = new Promise((resolve) => setTimeout(resolve, FIRST_RENDER_TIMEOUT_MS));
const texts = fetchTexts(language.peek());
const opened = texts.then(() => open({ receive, resync }, camera, receiveOfRobot));
const root = document.getElementById("app");

// otherwise the page is drawn once, with all its contents
void Promise.all([texts, Promise.race([firstRequestsSettled(), renderTimeout])]).then(() => {
  if (root) render(<App />, root);
});

// the window's self-check and the benchmarks wait for this attribute: page and editor are ready
void opened.then(() => {
  document.documentElement.dataset.ready = "true";
});
