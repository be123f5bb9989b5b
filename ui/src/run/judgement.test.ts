import { expect, test } from "vitest";
import type { JudgedEvent } from "../api/model";
import { textsOf } from "../i18n";
import { checksOf, verdictOf, withVerdict } from "./judgement";
import type { Sentence } from "./sentence";

const ptBR = textsOf("pt-BR");

const ended: Sentence = { text: "Terminou.", detail: "Em 3 s.", tone: "done" };

function judged(passed: boolean, missing: string | null): JudgedEvent {
  return {
    type: "judged",
    run: "r",
    passed,
    missing,
    block: null,
    cases: [],
    by_robot: false,
    not_judged: null,
  };
}

test("a run on a real robot that was not judged is neither a failure nor a success", () => {
  const notJudged = { ...judged(false, null), passed: null, not_judged: "Não julgada." };
  expect(withVerdict(ended, "r", notJudged, ptBR)).toEqual({ ...ended, detail: "Não julgada." });
});

test("a run that passed says so first", () => {
  const sentence = withVerdict(ended, "r", judged(true, null), ptBR);
  expect(sentence).toEqual({ text: ptBR.activity.passed, detail: "Terminou.", tone: "done" });
});

test("a run that did not pass says what is missing, after how it ended", () => {
  const sentence = withVerdict(ended, "r", judged(false, "O robô termina no início."), ptBR);
  expect([sentence.text, sentence.tone]).toEqual(["Terminou.", "notice"]);
  expect(sentence.detail).toContain("O robô termina no início.");
  expect(withVerdict(ended, "r", judged(false, null), ptBR).detail).toBe(ptBR.activity.toTheEnd);
});

test("of a run that did not pass, blocks that did not run are said before what it lacks", () => {
  const loose: Sentence = { ...ended, tone: "notice", idle: "Um bloco está solto e não rodou." };
  const { detail } = withVerdict(loose, "r", judged(false, "Comparem o fim do caminho."), ptBR);
  expect(detail).toBe(ptBR.activity.missing({ what: "Um bloco está solto e não rodou." }));
  expect(withVerdict(loose, "r", judged(true, null), ptBR).text).toBe(ptBR.activity.passed);
});

test("what to do about a run that failed is not replaced by that it is not judged", () => {
  const verdict = { ...judged(false, null), not_judged: "Não julgada." };
  const failed: Sentence = {
    text: "O robô não responde.",
    detail: "Ele está ligado?",
    tone: "fault",
  };
  expect(withVerdict(failed, "r", verdict, ptBR)).toBe(failed);
  expect(withVerdict(ended, "r", verdict, ptBR).detail).toBe("Não julgada.");
});

test("of a run that PINEL lost it is said once what happened, with what to do", () => {
  const lost: Sentence = { text: "O motor parou.", detail: "Apertem Rodar.", tone: "fault" };
  const verdict = judged(false, "O motor parou. Apertem Rodar.");
  expect(withVerdict(lost, "r", verdict, ptBR)).toBe(lost);
});

test("the judgement of another run is not said", () => {
  expect(withVerdict(ended, "other", judged(true, null), ptBR)).toBe(ended);
  expect(withVerdict(ended, null, null, ptBR)).toBe(ended);
});

test("the check list is that of the run, else what counts before any run", () => {
  const mission = { checks: ["Terminar na partida"] };
  const line = {
    criterion: "Terminar na partida",
    measured: "a 2 m de lá",
    state: "open",
  } as const;
  const checkStatus = { type: "checks_stand", run: "r", checks: [line] } as const;
  const before = [{ ...line, measured: "" }];
  expect(checksOf(mission, "r", { ...checkStatus, checks: [line] })).toEqual([line]);
  expect(checksOf(mission, "other", { ...checkStatus, checks: [line] })).toEqual(before);
  expect(checksOf(mission, null, null)).toEqual(before);
});

test("a verdict counts for its own run only", () => {
  expect(verdictOf("r", judged(true, null))?.passed).toBe(true);
  expect(verdictOf("other", judged(true, null))).toBeNull();
  expect(verdictOf(null, null)).toBeNull();
});
