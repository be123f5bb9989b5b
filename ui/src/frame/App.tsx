import type { ComponentType } from "preact";
import { NotLoaded } from "../kit/requests/NotLoaded";
import { driveRequest } from "../shell/files/drive_request";
import { lazy } from "../shell/lazy";
import { keyOf, ROUTES, route, type ScreenName } from "../shell/route";
import { connection, refreshStatus } from "../shell/session";
import { Header } from "./header/Header";
import { Locked } from "./Locked";
import { Messages } from "./Messages";
import { PinGate } from "./PinGate";
import { PARTS } from "./screens";

const DriveDialog = lazy(async () => (await import("./DriveDialog")).DriveDialog);

/** Screens for everybody with an action for the teacher; all others ask for the PIN themselves. */
const ASK_FOR_PIN: readonly ScreenName[] = ["start", "cards", "album"];

export function App() {
  if (connection.value === "locked") return <Locked />;
  return (
    <div class="page column">
      {!ROUTES[route.value.screen].isFull && <Header />}
      <Messages />
      <Screen />
      {driveRequest.value && <DriveDialog />}
    </div>
  );
}

function Screen() {
  const now = route.value;
  if (connection.value === "opening") return <main class="screen" aria-busy="true" />;
  if (connection.value === "failed") {
    return <NotLoaded as="screen" again={refreshStatus} actions={null} />;
  }
  const { screen, ...parameters } = now;
  const Part = PARTS[screen] as ComponentType<object>; // never undefined: screens.test.ts
  const part = <Part key={keyOf(now)} {...parameters} />;
  return ASK_FOR_PIN.includes(screen) ? <PinGate key={screen}>{part}</PinGate> : part;
}
