import { expect, test } from "vitest";
import type { Finding, RunPrediction, StepDifference, UnusualRun } from "../api/model";
import { textsOf } from "../i18n";
import { rowsOf } from "./rows";
import { notesOf, predictionText, robotText, unusualText } from "./words";

const VOICE = { texts: textsOf("pt-BR"), language: "pt-BR" } as const;
const TURN = { block: "t", action: "turn", amount: 90, tick: 30 };
const FINDING: Finding = {
  ...TURN,
  kind: "turn",
  how: "each",
  source: "camera",
  difference: -3.1,
  n: 4,
};
const STEP: StepDifference = {
  ...TURN,
  predicted_turned_deg: 90,
  predicted_moved_m: 0,
  turned_deg: 87,
  moved_m: 0,
};

const prediction = (findings: Finding[], more: Partial<RunPrediction> = {}): RunPrediction => ({
  robot: null,
  within_m: null,
  path: [],
  steps: [],
  awaits_input: false,
  is_cut: false,
  reads_sensors: false,
  knows_room: true,
  difference: {
    source: "odometry",
    steps: [STEP],
    at_end: null,
    is_whole: true,
    ate_m: null,
    parted: null,
    findings,
  },
  ...more,
});

test("a difference is said in words, with its source", () => {
  const text = (change: Partial<Finding>) =>
    predictionText(prediction([{ ...FINDING, ...change }]), VOICE);
  expect(text({})).toBe("O robô girou 3,1° a menos em cada “girar 90°” (4 vezes), pela câmera.");
  expect(text({ how: "average", source: "tape" })).toBe(
    "O robô girou 3,1° a menos em cada “girar 90°”, em média, pela fita.",
  );
  expect(text({ how: "average", block: null })).toContain("em cada giro, em média");
  const move = { kind: "move", action: "move_forward", amount: 1.5, difference: 0.042 } as const;
  expect(text({ ...move, how: "once" })).toBe(
    "O robô andou 4,2\u00a0cm a mais em um “andar para frente 1,5 m”, pela câmera.",
  );
});

test("without a difference the robot did what was predicted, by a named source", () => {
  expect(predictionText(prediction([]), VOICE)).toBe(
    "O robô fez o que estava previsto, pela odometria.",
  );
});

test("what limits a comparison is said", () => {
  const limited = prediction([], { awaits_input: true, reads_sensors: true, knows_room: false });
  const notes = notesOf(limited, VOICE).join(" ");
  expect(notes).toContain("A odometria é o que o robô conta pelas rodas");
  expect(notes).toContain("ficou sem resposta");
  expect(notes).toContain("só as paredes da sala");
  expect(notes).toContain("sala vazia");
});

test("a run out of the ordinary is said beside what is usual for its robot", () => {
  const outlier: UnusualRun = {
    ...FINDING,
    run: "r",
    difference: -22.7,
    usual: -2.7,
    n_runs: 5,
  };
  expect(unusualText(outlier, VOICE)).toEqual({
    text: "Fora do comum para este robô: girou 22,7° a menos em um “girar 90°”, pela câmera.",
    usual:
      "Nas outras 5 rodadas dele: girou 2,7° a menos. Uma roda patinou, ou alguém empurrou o robô?",
  });
  const path = { ...outlier, kind: "path", action: null, difference: 0.31, usual: 0.04 } as const;
  expect(unusualText(path, VOICE).text).toContain("o caminho ficou a 31,0\u00a0cm do previsto");
});

test("rows have the mean of all executions of a block", () => {
  const ahead = { ...STEP, block: "m", action: "move_forward", amount: 1, predicted_moved_m: 1 };
  const missing = { ...STEP, turned_deg: null };
  const rows = rowsOf([ahead, STEP, { ...STEP, turned_deg: 89 }, missing]);
  expect(rows.map(({ block, n, kind }) => [block, n, kind])).toEqual([
    ["m", 1, "move"],
    ["t", 3, "turn"],
  ]);
  expect(rows[1]?.measured).toBe(88);
});

test("a calibrated robot is named, with how far off it says it may be and whether the run agrees", () => {
  const robot = "Pioneer da sala 3";
  const by = (
    within_m: number | null,
    distance_m: number,
    source: "tape" | "odometry" = "tape",
  ) => {
    const whole = prediction([], { robot, within_m });
    const at_end = { source, distance_m, heading_deg: 0 };
    return robotText({ ...whole, difference: { ...whole.difference, at_end } }, VOICE);
  };
  expect(robotText(prediction([]), VOICE)).toBeNull();
  expect(by(null, 0.04)).toBe("Previsto com Pioneer da sala 3.");
  expect(by(0.06, 0.04, "odometry")).toContain("para a até 6,0\u00a0cm do lugar previsto");
  expect(by(0.06, 0.04)).toContain(
    "parou a 4,0\u00a0cm do lugar previsto, pela fita, dentro dos 6,0",
  );
  expect(by(0.06, 0.08)).toContain("a previsão anuncia até 6,0\u00a0cm. Uma roda patinou");
  expect(notesOf(prediction([], { robot }), VOICE).join(" ")).toContain(
    "A odometria não percebe os",
  );
});
