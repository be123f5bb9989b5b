import type { ComponentType } from "preact";
import { NotLoaded } from "../kit/requests/NotLoaded";
import { laterScreen } from "../shell/later";
import {
  type FirstScreen,
  keyOf,
  type ParametersOf,
  ROUTES,
  route,
  SCREENS,
  type ScreenName,
} from "../shell/route";
import { connection, refreshStatus } from "../shell/session";
import { StartScreen } from "../start/StartScreen";
import { StudioScreen } from "../studio/StudioScreen";
import { Header } from "./header/Header";
import { Locked } from "./Locked";
import { Messages } from "./Messages";

/** Screens of the first bundle; all others are loaded on demand. */
const FIRST: { [Name in FirstScreen]: ComponentType<ParametersOf<Name>> } = {
  start: StartScreen,
  studio: StudioScreen,
};

const PARTS = Object.fromEntries(
  SCREENS.map((name) => {
    const { load } = ROUTES[name];
    return [name, load ? laterScreen(load) : FIRST[name as FirstScreen]];
  }),
) as Readonly<Record<ScreenName, ComponentType<object>>>;

export function App() {
  if (connection.value === "locked") return <Locked />;
  return (
    <div class="page">
      <Header />
      <Messages />
      <Screen />
    </div>
  );
}

function Screen() {
  const now = route.value;
  if (connection.value === "opening") return <main class="screen" aria-busy="true" />;
  if (connection.value === "failed") {
    return <NotLoaded as="screen" again={refreshStatus} ways={null} />;
  }
  const { screen, ...parameters } = now;
  const Part = PARTS[screen];
  return <Part key={keyOf(now)} {...parameters} />;
}
