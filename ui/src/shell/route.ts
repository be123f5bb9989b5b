import { signal } from "@preact/signals";
import type { JSX } from "preact";

export const TEACHER_PARTS = [
  "lessons",
  "plan",
  "activities",
  "classes",
  "camera",
  "robot",
  "files",
  "computer",
] as const;
export type TeacherPart = (typeof TEACHER_PARTS)[number];

/** A component with these parameters; explicit in each row, because a screen's type may depend on `Route`. */
type Screen<Parameters = unknown> = Promise<(parameters: Parameters) => JSX.Element | null>;

interface Row {
  /** The address after `#/`: `:name` is a parameter, `:name?` an optional one, null if missing. */
  readonly pattern: string;
  /** Allowed values of a parameter; any other value becomes the first of them. */
  readonly choices?: Readonly<Record<string, readonly string[]>>;
  /** Whether the header shows the group and its program. */
  readonly ofGroup?: true;
  /** Parameters whose change remounts the screen; by default all. */
  readonly remount?: readonly string[];
  /** Imports the screen; without it the screen is in the first bundle (`frame/App`). */
  readonly load?: () => Screen<never>;
}

/**
 * All screens: name, address, component. The title is the text `titles.NAME`. `Route`, `parse`, `hashOf`, the screen
 * switch of `frame/App` and prefetching derive from this table.
 */
const ROWS = {
  start: { pattern: "" },
  studio: { pattern: "program/:program", ofGroup: true },
  work: {
    pattern: "work/:group",
    ofGroup: true,
    load: async (): Screen<{ group: string }> => (await import("../work/WorkScreen")).WorkScreen,
  },
  activities: {
    pattern: "activities/:group",
    ofGroup: true,
    load: async (): Screen<{ group: string }> =>
      (await import("../activities/ActivitiesScreen")).ActivitiesScreen,
  },
  practice: {
    pattern: "practice",
    load: async (): Screen => (await import("../practice/PracticeScreen")).PracticeScreen,
  },
  replay: {
    pattern: "run/:run",
    ofGroup: true,
    load: async (): Screen<{ run: string }> =>
      (await import("../replay/ReplayScreen")).ReplayScreen,
  },
  versions: {
    pattern: "versions/:program/:version?",
    ofGroup: true,
    remount: ["program"],
    load: async (): Screen<{ program: string; version: string | null }> =>
      (await import("../versions")).VersionsScreen,
  },
  differences: {
    pattern: "differences/:program/:before/:after",
    ofGroup: true,
    load: async (): Screen<{ program: string; before: string; after: string }> =>
      (await import("../versions")).DifferencesScreen,
  },
  teacher: {
    pattern: "teacher/:part",
    choices: { part: TEACHER_PARTS },
    remount: [],
    load: async (): Screen<{ part: TeacherPart }> =>
      (await import("../teacher/TeacherScreen")).TeacherScreen,
  },
  lesson: {
    pattern: "lesson/:lesson",
    load: async (): Screen<{ lesson: string }> =>
      (await import("../teacher/review/lesson/LessonScreen")).LessonScreen,
  },
  runs: {
    pattern: "runs",
    load: async (): Screen => (await import("../teacher/review/runs/RunsScreen")).RunsScreen,
  },
  cards: {
    pattern: "cards",
    load: async (): Screen => (await import("../teacher/cards/CardsScreen")).CardsScreen,
  },
  compare: {
    pattern: "compare/:first/:second",
    load: async (): Screen<{ first: string; second: string }> =>
      (await import("../teacher/review/compare/CompareScreen")).CompareScreen,
  },
} as const satisfies Record<string, Row>;

type Rows = typeof ROWS;
export type ScreenName = keyof Rows;

type Named<Pattern extends string> = Pattern extends `${infer One}/${infer Rest}`
  ? Named<One> & Named<Rest>
  : Pattern extends `:${infer Name}?`
    ? Record<Name, string | null>
    : Pattern extends `:${infer Name}`
      ? Record<Name, string>
      : unknown;

type Chosen<R> = R extends { choices: infer Choices extends Record<string, readonly string[]> }
  ? { [Name in keyof Choices]: Choices[Name][number] }
  : unknown;

/** The parameters of a screen, from its pattern. */
export type ParametersOf<Name extends ScreenName> = Named<Rows[Name]["pattern"]> &
  Chosen<Rows[Name]>;

/** A place in the page. */
export type Route = { [Name in ScreenName]: { screen: Name } & ParametersOf<Name> }[ScreenName];

/** Screens of the first bundle. */
export type FirstScreen = {
  [Name in ScreenName]: Rows[Name] extends { load: unknown } ? never : Name;
}[ScreenName];

/** Compile-time check: each screen takes the parameters of its pattern. */
type Misfit = {
  [Name in ScreenName]: Rows[Name] extends { load: () => Screen<infer Taken> }
    ? ParametersOf<Name> extends Taken
      ? never
      : Name
    : never;
}[ScreenName];
null as unknown as Misfit satisfies never;

export const ROUTES: Readonly<Record<ScreenName, Row>> = ROWS;
export const SCREENS = Object.keys(ROWS) as ScreenName[];

type Values = Record<string, string | null>;

/** The parameters of an address; null if it does not match the pattern. */
function read({ pattern, choices = {} }: Row, given: readonly string[]): Values | null {
  const values: Values = {};
  for (const [index, part] of pattern.split("/").entries()) {
    const here = given[index] || null;
    const name = /^:(\w+)/.exec(part)?.[1];
    if (!name) {
      if (part !== (here ?? "")) return null;
    } else if (choices[name]) {
      values[name] = choices[name].find((one) => one === here) ?? choices[name][0] ?? null;
    } else {
      if (!here && !part.endsWith("?")) return null;
      values[name] = here;
    }
  }
  return values;
}

/** The route of the address after `#`, which is the whole navigation state; the start if unknown. */
export function parse(hash: string): Route {
  const given = hash.replace(/^#\/?/, "").split("/");
  for (const screen of SCREENS) {
    const values = read(ROUTES[screen], given);
    if (values) return { screen, ...values } as Route;
  }
  return { screen: "start" };
}

/** The parameters of a route by name. */
function valuesOf(to: Route): Values {
  const { screen, ...values } = to;
  return values;
}

export function hashOf(to: Route): string {
  const values = valuesOf(to);
  const parts = ROUTES[to.screen].pattern.split("/").map((part) => {
    const name = /^:(\w+)/.exec(part)?.[1];
    return name ? values[name] : part;
  });
  return `#/${parts.filter(Boolean).join("/")}`;
}

/** Key of the screen's component: a route with another key remounts it. */
export function keyOf(to: Route): string {
  const values = valuesOf(to);
  const names = ROUTES[to.screen].remount ?? Object.keys(values);
  return [to.screen, ...names.map((name) => values[name])].join(" ");
}

export const route = signal<Route>(parse(location.hash));

/** Blocks navigation, for example while the server is gone: unsaved work stays on the screen. */
export const navigationBlocked = signal(false);

window.addEventListener("hashchange", () => {
  if (navigationBlocked.peek()) history.replaceState(null, "", hashOf(route.peek()));
  else route.value = parse(location.hash);
});

export function go(to: Route): void {
  location.hash = hashOf(to);
}
