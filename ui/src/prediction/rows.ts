import type { StepDifference } from "../api/model";

/** All executions of one block, or of one command of a program without blocks. */
export interface DifferenceRow {
  readonly block: string | null;
  readonly action: string;
  readonly amount: number | null;
  /** Tick of the first execution. */
  readonly tick: number;
  readonly n: number;
  readonly kind: "turn" | "move" | null;
  /** Means of all executions, degrees or metres; null where nothing was measured. */
  readonly predicted: number;
  readonly measured: number | null;
}

/** A step that turns less, or moves less, is none. */
const A_TURN_DEG = 3;
const A_MOVE_M = 0.03;

/** The differences of the blocks in the order of their first execution. */
export function rowsOf(steps: readonly StepDifference[]): DifferenceRow[] {
  const groups = new Map<string, StepDifference[]>();
  for (const step of steps) {
    const key = `${step.block} ${step.action} ${step.amount}`;
    groups.set(key, [...(groups.get(key) ?? []), step]);
  }
  return [...groups.values()].flatMap((members) => rowOf(members) ?? []);
}

function rowOf(members: readonly StepDifference[]): DifferenceRow | null {
  const [first] = members;
  if (!first) return null;
  const kind = kindOf(first);
  const ofKind = (step: StepDifference) =>
    kind === "turn"
      ? ([step.predicted_turned_deg, step.turned_deg] as const)
      : ([step.predicted_moved_m, step.moved_m] as const);
  const measured = members.map((step) => ofKind(step)[1]).filter((value) => value !== null);
  return {
    ...first,
    n: members.length,
    kind,
    predicted: mean(members.map((step) => ofKind(step)[0])),
    measured: measured.length > 0 ? mean(measured) : null,
  };
}

function kindOf(step: StepDifference): DifferenceRow["kind"] {
  if (Math.abs(step.predicted_moved_m) >= A_MOVE_M && step.action !== "arc") return "move";
  return Math.abs(step.predicted_turned_deg) >= A_TURN_DEG ? "turn" : null;
}

const mean = (values: readonly number[]) =>
  values.reduce((sum, value) => sum + value, 0) / values.length;
