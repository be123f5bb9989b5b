import { describe, expect, test } from "vitest";
import { ptBR } from "../i18n/pt-BR";
import { IDLE, type RunView } from "./reducer";
import { sentenceOf, timesIn } from "./sentence";

const voice = { texts: ptBR, language: "pt-BR", timesOf: () => 4 } as const;

const moving = (kind: string, amount: number, done: number): RunView => ({
  ...IDLE,
  run: "r",
  phase: "running",
  stack: [{ block: "b", pointer: "/commands/0", action: kind, amount, round: 0 }],
  motion: { kind, amount, done },
});

const over = (phase: "finished" | "failed" | "stopped", ending: object): RunView => ({
  ...IDLE,
  run: "r",
  phase,
  ending: {
    reason: null,
    params: {},
    block: null,
    durationS: 1,
    pathLengthM: 4,
    closingErrorM: 0,
    ...ending,
  },
});

const said = (view: RunView) => sentenceOf(view, voice)?.text.replaceAll("\u00a0", " ");

describe("what the robot does, in words", () => {
  test.each([
    [moving("move_forward", 1, 0.62), "Andando: 0,62 m de 1,00 m"],
    [moving("move_backward", -1, -0.5), "Andando de ré: 0,50 m de 1,00 m"],
    [moving("turn", 90, 47.2), "Girando à esquerda: 47° de 90°"],
    [moving("turn", -90, -47.2), "Girando à direita: 47° de 90°"],
    [moving("wait", 3, 1.2), "Esperando: 1,2 s de 3,0 s"],
  ])("a motion tells how far it is: %#", (view, words) => {
    expect(said(view)).toBe(words);
  });

  test("a loop tells its round", () => {
    const loop = { block: "l", pointer: "/commands/0", action: "repeat", amount: null, round: 2 };
    const view = { ...moving("turn", 90, 1), stack: [loop] };
    expect(sentenceOf(view, voice)?.more).toBe("volta 2 de 4");
  });

  test("an end tells how far from the start", () => {
    expect(said(over("finished", {}))).toBe("Programa terminou: voltou ao ponto de partida");
    expect(said(over("finished", { closingErrorM: 1.234 }))).toBe(
      "Programa terminou: parou a 1,23 m da partida",
    );
    expect(said(over("finished", { pathLengthM: 0 }))).toBe("Programa terminou");
  });

  test("a failure has the server's words and remedy", () => {
    const sentence = sentenceOf(
      over("failed", { reason: "blocked", params: { done: 3.78, amount: 9 } }),
      voice,
    );
    expect(sentence?.tone).toBe("fault");
    expect(sentence?.text).toContain("3,78");
    expect(sentence?.more).not.toBe("");
  });

  test("an unknown reason still says something", () => {
    expect(said(over("failed", { reason: "no_such_code" }))).toBe(ptBR.status.failed);
  });
});

test("how often a loop goes round is read from the document", () => {
  const document = { commands: [{ action: "stop" }, { action: "repeat", times: 5, commands: [] }] };
  expect(timesIn(document, "/commands/1")).toBe(5);
  expect(timesIn(document, "/commands/9/commands/0")).toBeNull();
  expect(timesIn(null, "/commands/0")).toBeNull();
});
