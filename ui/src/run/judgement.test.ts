import { expect, test } from "vitest";
import { textsOf } from "../i18n";
import { withJudgement } from "./judgement";
import type { Sentence } from "./sentence";

const ptBR = textsOf("pt-BR");

const ended: Sentence = { text: "Terminou.", more: "Em 3 s.", tone: "done" };

function judged(passed: boolean, missing: string | null) {
  return { type: "judged", run: "r", passed, missing } as const;
}

test("a run that passed says so first", () => {
  const said = withJudgement(ended, "r", judged(true, null), ptBR);
  expect(said).toEqual({ text: ptBR.activity.passed, more: "Terminou.", tone: "done" });
});

test("a run that did not pass says what is missing, after how it ended", () => {
  const said = withJudgement(ended, "r", judged(false, "O robô termina no início."), ptBR);
  expect([said.text, said.tone]).toEqual(["Terminou.", "notice"]);
  expect(said.more).toContain("O robô termina no início.");
  expect(withJudgement(ended, "r", judged(false, null), ptBR).more).toBe(ptBR.activity.toTheEnd);
});

test("the judgement of another run is not said", () => {
  expect(withJudgement(ended, "other", judged(true, null), ptBR)).toBe(ended);
  expect(withJudgement(ended, null, null, ptBR)).toBe(ended);
});
