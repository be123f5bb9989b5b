import type { Proposal } from "../../api/model";
import { CHECK_FIELDS } from "./check_fields";

/** A check of an activity, as docs/activities.md describes it. */
export type Check = Readonly<Record<string, unknown>>;
export type CheckKind = keyof typeof CHECK_FIELDS;
/** A parameter in the form, declared as `FormField` in pinel_desktop/activities/checks/base.py. */
export type CheckField = (typeof CHECK_FIELDS)[CheckKind][number];
type NumberField = Extract<CheckField, { input: "number" }>;

/** The teacher's choice for one kind of check. */
export interface Chosen {
  readonly on: boolean;
  readonly check: Check;
}

/** Choices for all kinds of checks that the form offers for a solution, in its order. */
export type Choices = Readonly<Partial<Record<CheckKind, Chosen>>>;

export const fieldsOf = (kind: CheckKind): readonly CheckField[] => CHECK_FIELDS[kind];
export const offered = (choices: Choices) => Object.entries(choices) as [CheckKind, Chosen][];
export const chosen = (choices: Choices) => offered(choices).filter(([, { on }]) => on);

/** The number that the form shows for a parameter, such as centimetres for metres. */
export const shownNumber = ({ key, factor }: NumberField, check: Check): number =>
  Math.round(Number(check[key]) * factor * 1000) / 1000;

/** Choices with the values of the solution, all off. Choices that are on in `previous` keep their values. */
export function proposed({ checks }: Proposal, previous: Choices = {}): Choices {
  const choices = checks.map((check): [CheckKind, Chosen] => {
    const kind = check.check as CheckKind;
    const before = previous[kind];
    return [
      kind,
      before?.on
        ? { on: true, check: { ...check, ...written(kind, before.check) } }
        : { on: false, check },
    ];
  });
  return Object.fromEntries(choices);
}

/** The parameters that the teacher may edit. */
function written(kind: CheckKind, check: Check): Check {
  const fields = fieldsOf(kind).filter(({ input }) => input !== "shown");
  return Object.fromEntries(fields.map(({ key }) => [key, check[key]]));
}

/** The chosen checks. */
export const checksOf = (choices: Choices): Check[] =>
  chosen(choices).map(([, { check }]) => check);

/** The form's choices for an activity's checks, and the other checks, which the form cannot show and keeps. */
export function choicesOf(checks: readonly Check[]): {
  formChoices: Choices;
  others: readonly Check[];
} {
  const formChoices: Partial<Record<CheckKind, Chosen>> = {};
  const others: Check[] = [];
  for (const check of checks) {
    const kind = check.check as CheckKind;
    if (isOfForm(check) && !formChoices[kind]) formChoices[kind] = { on: true, check };
    else others.push(check);
  }
  return { formChoices, others };
}

const isOfForm = (check: Check) =>
  Object.hasOwn(CHECK_FIELDS, String(check.check)) &&
  fieldsOf(check.check as CheckKind).every(
    (field) => field.input !== "fixed" || check[field.key] === field.value,
  );
