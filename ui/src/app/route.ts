import { signal } from "@preact/signals";

export type Route =
  | { screen: "start" }
  | { screen: "studio"; program: string }
  | { screen: "work"; group: string }
  | { screen: "replay"; run: string }
  | { screen: "versions"; program: string; version: string | null }
  | { screen: "differences"; program: string; before: string; after: string }
  | { screen: "lesson"; lesson: string }
  | { screen: "runs" }
  | { screen: "compare"; runs: readonly [string, string] }
  | { screen: "teacher"; part: TeacherPart };

export const TEACHER_PARTS = ["lessons", "classes", "files", "computer"] as const;
export type TeacherPart = (typeof TEACHER_PARTS)[number];

/** The address after `#` is the whole state of navigation, so that Back works. */
export function parse(hash: string): Route {
  const [, screen, id, other, more] = hash.replace(/^#/, "").split("/");
  if (screen === "program" && id) return { screen: "studio", program: id };
  if (screen === "work" && id) return { screen: "work", group: id };
  if (screen === "run" && id) return { screen: "replay", run: id };
  if (screen === "versions" && id) return { screen, program: id, version: other || null };
  if (screen === "differences" && id && other && more) {
    return { screen, program: id, before: other, after: more };
  }
  if (screen === "lesson" && id) return { screen, lesson: id };
  if (screen === "runs") return { screen };
  if (screen === "compare" && id && other) return { screen, runs: [id, other] };
  if (screen === "teacher") {
    return { screen, part: TEACHER_PARTS.find((one) => one === id) ?? "lessons" };
  }
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
    case "versions":
      return `#/versions/${[route.program, route.version].filter(Boolean).join("/")}`;
    case "differences":
      return `#/differences/${route.program}/${route.before}/${route.after}`;
    case "lesson":
      return `#/lesson/${route.lesson}`;
    case "runs":
      return "#/runs";
    case "compare":
      return `#/compare/${route.runs.join("/")}`;
    case "teacher":
      return `#/teacher/${route.part}`;
    default:
      return "#/";
  }
}

export const route = signal<Route>(parse(location.hash));

/** Nothing else can be shown now: what is on the screen stays, above all what is not saved. */
export const staying = signal(false);

window.addEventListener("hashchange", () => {
  if (staying.peek()) history.replaceState(null, "", hashOf(route.peek()));
  else route.value = parse(location.hash);
});

export function go(to: Route): void {
  location.hash = hashOf(to);
}
