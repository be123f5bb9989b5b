import { signal } from "@preact/signals";

export type Route =
  | { screen: "start" }
  | { screen: "studio"; program: string }
  | { screen: "work"; group: string }
  | { screen: "replay"; run: string };

/** The address after `#` is the whole state of navigation, so that Back works. */
export function parse(hash: string): Route {
  const [, screen, id] = hash.replace(/^#/, "").split("/");
  if (screen === "program" && id) return { screen: "studio", program: id };
  if (screen === "work" && id) return { screen: "work", group: id };
  if (screen === "run" && id) return { screen: "replay", run: id };
  return { screen: "start" };
}

export function hashOf(route: Route): string {
  switch (route.screen) {
    case "studio":
      return `#/program/${route.program}`;
    case "work":
      return `#/work/${route.group}`;
    case "replay":
      return `#/run/${route.run}`;
    default:
      return "#/";
  }
}

export const route = signal<Route>(parse(location.hash));

window.addEventListener("hashchange", () => {
  route.value = parse(location.hash);
});

export function go(to: Route): void {
  location.hash = hashOf(to);
}
