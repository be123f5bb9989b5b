import { signal } from "@preact/signals";

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

interface Row {
  /** The address after `#/`: `:name` is a parameter, `:name?` an optional one, null if missing. */
  readonly pattern: string;
  /** Allowed values of a parameter; any other value becomes the first of them. */
  readonly choices?: Readonly<Record<string, readonly string[]>>;
  /** Whether the header shows the group and its program. */
  readonly ofGroup?: true;
  /** Whether the screen fills the window, without a header. */
  readonly isFull?: true;
  /** Parameters whose change remounts the screen; by default all. */
  readonly remount?: readonly string[];
}

/**
 * All screens: name and address. The title is the text `titles.NAME`. The component is in a file of the
 * screen's name, which `frame/screens` imports. `Route`, `parse`, `hashOf` and the switch of screens
 * derive from this table.
 */
const ROWS = {
  start: { pattern: "" },
  studio: { pattern: "program/:program", ofGroup: true },
  work: { pattern: "work/:group", ofGroup: true },
  activities: { pattern: "activities/:group", ofGroup: true },
  album: { pattern: "album/:group", ofGroup: true },
  practice: { pattern: "practice" },
  replay: { pattern: "run/:run", ofGroup: true },
  versions: { pattern: "versions/:program/:version?", ofGroup: true, remount: ["program"] },
  differences: { pattern: "differences/:program/:before/:after", ofGroup: true },
  teacher: { pattern: "teacher/:part", choices: { part: TEACHER_PARTS }, remount: [] },
  lesson: { pattern: "lesson/:lesson" },
  runs: { pattern: "runs" },
  cards: { pattern: "cards" },
  notices: { pattern: "notices" },
  compare: { pattern: "compare/:first/:second" },
  presentedprogram: {
    pattern: "present/:window/program/:program",
    choices: { window: ["same", "second"] },
    isFull: true,
  },
  presentation: {
    pattern: "present/:window/:first/:second?",
    choices: { window: ["same", "second"] },
    isFull: true,
  },
  manuals: { pattern: "manuals/:manual?/:section?", remount: [] },
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

/** The parameters of a screen, from its pattern: the properties of its component. */
export type ParametersOf<Name extends ScreenName> = Named<Rows[Name]["pattern"]> &
  Chosen<Rows[Name]>;

/** A screen with its parameters. */
export type Route = { [Name in ScreenName]: { screen: Name } & ParametersOf<Name> }[ScreenName];

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

/** Key of the screen's component: a route with another key remounts the component. */
export function keyOf(to: Route): string {
  const values = valuesOf(to);
  const names = ROUTES[to.screen].remount ?? Object.keys(values);
  return [to.screen, ...names.map((name) => values[name])].join(" ");
}

export const route = signal<Route>(parse(location.hash));

/** Blocks navigation, for example while the server is unreachable: unsaved work stays on the screen. */
export const navigationBlocked = signal(false);

window.addEventListener("hashchange", () => {
  if (navigationBlocked.peek()) history.replaceState(null, "", hashOf(route.peek()));
  else route.value = parse(location.hash);
});

export function go(to: Route): void {
  location.hash = hashOf(to);
}
