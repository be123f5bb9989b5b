import type { Measured } from "../../api/model";

/** A check of an activity, as docs/activities.md has it. */
export type Check = Readonly<Record<string, unknown>>;

/** A number of a check that the teacher chooses. */
export interface NumberOf {
  readonly name: string;
  readonly least: number;
  readonly most: number;
  readonly step: number;
  /** What the form proposes. */
  initial(measured: Measured): number;
}

/** What the teacher has chosen of one kind of check. */
export interface Chosen {
  readonly on: boolean;
  readonly numbers: Readonly<Record<string, number>>;
  /** A place or a text. */
  readonly text: string;
}

/** A kind of check that the form offers, in the order in which it does. */
interface CheckRow {
  /** Whether it can be of use for what the solution does. */
  isOffered(measured: Measured): boolean;
  readonly numbers: readonly NumberOf[];
  /** The places or the text to begin with; without it the check has none. */
  readonly text?: (measured: Measured) => string;
  make(numbers: Readonly<Record<string, number>>, measured: Measured, text: string): Check;
  /** Numbers and text of such a check; null for another one. */
  read(check: Check): { numbers: Record<string, number>; text: string } | null;
}

const number = (
  name: string,
  [least, most, step]: readonly [number, number, number],
  initial: (measured: Measured) => number,
): NumberOf => ({ name, least, most, step, initial });

const reads =
  (kind: string, numbers: Readonly<Record<string, string>> = {}, textKey = "", factor = 1) =>
  (check: Check) => {
    if (check.check !== kind) return null;
    const found = Object.entries(numbers).map(([name, key]): [string, number] => [
      name,
      Math.round(Number(check[key]) * factor * 1000) / 1000,
    ]);
    return { numbers: Object.fromEntries(found), text: String(check[textKey] ?? "") };
  };

const CENTIMETRES = [1, 500, 1] as const;
const COUNT = [1, 1000, 1] as const;
const isDrawn = ({ gap_m }: Measured) => gap_m !== null;
const always = () => true;
const tenth = (value: number) => Math.round(value * 10) / 10;

export const CHECK_ROWS = {
  ends_in: {
    isOffered: ({ end_zone }) => end_zone !== "",
    numbers: [],
    text: ({ end_zone }) => end_zone,
    make: (_, __, zone) => ({ check: "ends_in", zone }),
    read: reads("ends_in", {}, "zone"),
  },
  ends_at: {
    isOffered: always,
    numbers: [number("cm", CENTIMETRES, () => 10)],
    make: ({ cm = 10 }, { end_x_m, end_y_m }) => ({
      check: "ends_at",
      x_m: end_x_m,
      y_m: end_y_m,
      within_m: cm / 100,
    }),
    read: reads("ends_at", { cm: "within_m" }, "", 100),
  },
  visits: {
    isOffered: ({ zones }) => zones.length > 0,
    numbers: [],
    make: (_, { zones }) => ({ check: "visits", zones }),
    read: reads("visits"),
  },
  touches_nothing: {
    isOffered: ({ touched }) => !touched,
    numbers: [],
    make: () => ({ check: "touches_nothing" }),
    read: reads("touches_nothing"),
  },
  draws: {
    isOffered: ({ template }) => template !== null,
    numbers: [number("cm", [2, 100, 1], () => 6)],
    make: ({ cm = 6 }, { template, gap_m }) => ({
      check: "draws",
      template: template ?? [],
      tolerance: cm / 100,
      scale: false,
      of: gap_m === null ? "path" : "trail",
    }),
    read: reads("draws", { cm: "tolerance" }, "", 100),
  },
  closed: {
    isOffered: isDrawn,
    numbers: [number("cm", CENTIMETRES, () => 5)],
    make: ({ cm = 5 }) => ({ check: "closed", within_m: cm / 100 }),
    read: reads("closed", { cm: "within_m" }, "", 100),
  },
  turned_total: {
    isOffered: ({ turned_deg }) => turned_deg > 0,
    numbers: [
      number("least", [0, 100_000, 5], ({ turned_deg }) => Math.max(0, turned_deg - 10)),
      number("most", [1, 100_000, 5], ({ turned_deg }) => turned_deg + 10),
    ],
    make: ({ least = 0, most = 1 }) => ({
      check: "turned_total",
      at_least_deg: least,
      at_most_deg: most,
    }),
    read: reads("turned_total", { least: "at_least_deg", most: "at_most_deg" }),
  },
  path_length: {
    isOffered: always,
    numbers: [
      number("least", [0, 10_000, 0.1], ({ path_m }) => Math.max(0, tenth(path_m - 0.2))),
      number("most", [0.1, 10_000, 0.1], ({ path_m }) => tenth(path_m + 0.2)),
    ],
    make: ({ least = 0, most = 1 }) => ({
      check: "path_length",
      at_least_m: least,
      at_most_m: most,
    }),
    read: reads("path_length", { least: "at_least_m", most: "at_most_m" }),
  },
  block_count: {
    isOffered: always,
    numbers: [number("most", COUNT, ({ n_blocks }) => Math.max(1, n_blocks))],
    make: ({ most = 1 }) => ({ check: "block_count", at_most: most }),
    read: reads("block_count", { most: "at_most" }),
  },
  nesting: {
    isOffered: ({ n_nested }) => n_nested > 0,
    numbers: [],
    make: () => ({ check: "nesting", at_least: 1 }),
    read: (check) => (check.at_least === 1 ? reads("nesting")(check) : null),
  },
  time: {
    isOffered: always,
    numbers: [number("most", COUNT, ({ time_s }) => Math.max(1, Math.ceil(time_s * 1.5)))],
    make: ({ most = 1 }) => ({ check: "time", at_most_s: most }),
    read: reads("time", { most: "at_most_s" }),
  },
  says: {
    isOffered: ({ said }) => said.length > 0,
    numbers: [],
    text: ({ said }) => said[0] ?? "",
    make: (_, __, text) => ({ check: "says", text }),
    read: reads("says", {}, "text"),
  },
  mark_count: {
    isOffered: ({ n_marks }) => n_marks > 0,
    numbers: [number("n", COUNT, ({ n_marks }) => Math.max(1, n_marks))],
    make: ({ n = 1 }) => ({ check: "mark_count", n }),
    read: reads("mark_count", { n: "n" }),
  },
} as const satisfies Record<string, CheckRow>;

export type CheckKind = keyof typeof CHECK_ROWS;
export type Choices = Readonly<Record<CheckKind, Chosen>>;
export const CHECK_KINDS = Object.keys(CHECK_ROWS) as CheckKind[];

export const rowOf = (kind: CheckKind): CheckRow => CHECK_ROWS[kind];

/** Nothing chosen, with the numbers of what the solution does; `kept` choices keep theirs. */
export function proposed(measured: Measured, kept: Partial<Choices> = {}): Choices {
  const choices = CHECK_KINDS.map((kind): [CheckKind, Chosen] => {
    const { numbers, text, isOffered } = rowOf(kind);
    const initial = numbers.map((one): [string, number] => [one.name, one.initial(measured)]);
    const before = kept[kind];
    const fresh = { on: false, numbers: Object.fromEntries(initial), text: text?.(measured) ?? "" };
    return [kind, before?.on && isOffered(measured) ? before : fresh];
  });
  return Object.fromEntries(choices) as unknown as Choices;
}

/** The checks that were chosen, for a solution that does this. */
export function checksOf(choices: Choices, measured: Measured): Check[] {
  return CHECK_KINDS.filter((kind) => choices[kind].on && rowOf(kind).isOffered(measured)).map(
    (kind) => rowOf(kind).make(choices[kind].numbers, measured, choices[kind].text),
  );
}

/** The choices of an activity's checks, and the checks that the form does not offer, which stay as they are. */
export function choicesOf(checks: readonly Check[]): {
  kept: Partial<Choices>;
  others: readonly Check[];
} {
  const kept: Partial<Record<CheckKind, Chosen>> = {};
  const others: Check[] = [];
  for (const check of checks) {
    const kind = CHECK_KINDS.find((one) => !kept[one] && rowOf(one).read(check));
    const found = kind && rowOf(kind).read(check);
    if (kind && found) kept[kind] = { on: true, ...found };
    else others.push(check);
  }
  return { kept, others };
}
