import { describe, expect, test } from "vitest";
import { textsOf } from "../i18n";
import { IDLE, type RunView } from "./reducer";
import { parameterIn, sentenceOf } from "./sentence";

const ptBR = textsOf("pt-BR");

const context = { texts: ptBR, language: "pt-BR", parameterOf: () => 4 } as const;

const moving = (kind: string, amount: number, done: number): RunView => ({
  ...IDLE,
  run: "r",
  phase: "running",
  stack: [{ block: "b", pointer: "/commands/0", action: kind, amount, round: 0, roundTick: 0 }],
  motion: { kind, amount, done, since: 0 },
});

const over = (phase: "finished" | "failed" | "stopped", ending: object): RunView => ({
  ...IDLE,
  run: "r",
  phase,
  moved: true,
  ending: {
    reason: null,
    params: {},
    block: null,
    durationS: 1,
    pathLengthM: 4,
    closingErrorM: 0,
    estimatedClosingErrorM: 0,
    ...ending,
  },
});

const sentenceText = (view: RunView) => sentenceOf(view, context)?.text.replaceAll("\u00a0", " ");

describe("what the robot does, in words", () => {
  test.each([
    [moving("move_forward", 1, 0.62), "Andando: 0,62 m de 1,00 m"],
    [moving("move_backward", -1, -0.5), "Andando de ré: 0,50 m de 1,00 m"],
    [moving("turn", 90, 47.2), "Girando à esquerda: 47° de 90°"],
    [moving("turn", -90, -47.2), "Girando à direita: 47° de 90°"],
    [moving("wait", 3, 1.2), "Esperando: 1,2 s de 3,0 s"],
  ])("a motion tells how far it is: %#", (view, expected) => {
    expect(sentenceText(view)).toBe(expected);
  });

  const command = (action: string): RunView => ({
    ...moving(action, 0, 0),
    motion: null,
  });
  const written = (values: Record<string, unknown>) => ({
    ...context,
    parameterOf: (_pointer: string, name: string) => values[name],
  });
  const commandText = (view: RunView, values = {}) =>
    sentenceOf(view, written(values))?.text.replaceAll("\u00a0", " ");

  test("a curve tells its direction and how far it is", () => {
    expect(sentenceText(moving("arc", 90, 30))).toBe("Curva à esquerda: 30° de 90°");
    expect(sentenceText(moving("arc", -90, -30))).toBe("Curva à direita: 30° de 90°");
  });

  test("going to a point names it where it is written in the program", () => {
    expect(commandText(command("go_to"), { x: 1, y: -2 })).toBe("Indo até x 1,00 m, y −2,00 m");
    expect(commandText(command("go_to"), { x: { var: "a" }, y: 2 })).toBe("Indo até o ponto");
    expect(commandText(command("go_to_place"), { place: "E" })).toBe("Indo até o lugar “E”");
    expect(commandText(command("go_to_place"), { place: { var: "a" } })).toBe("Indo até o lugar");
  });

  test("waiting for a condition tells for how long at most", () => {
    expect(commandText(command("wait_until"))).toBe("Esperando a condição");
    expect(commandText(command("wait_until"), { timeout: 5 })).toBe(
      "Esperando a condição (até 5,0 s)",
    );
  });

  test.each([
    [0.3, 0, "Andando a 0,30 m/s"],
    [-0.3, 0, "Andando de ré a 0,30 m/s"],
    [0.3, -1, "Em curva à direita a 0,30 m/s"],
    [0, Math.PI / 4, "Girando à esquerda a 45°/s"],
    [0, 0, "Rodando o programa"],
  ])("a velocity that lasts is told: %d m/s, %d rad/s", (linear, angular, text) => {
    expect(sentenceText({ ...command("while"), speed: { linear, angular } })).toBe(text);
  });

  test("an open question waits for the group", () => {
    const question = { block: "b", text: "?", variable: "x" };
    const view = { ...command("ask"), output: { ...IDLE.output, question } };
    expect(sentenceText(view)).toBe("Esperando a resposta do grupo");
  });

  test("what was just said is in the sentence, for a while", () => {
    const line = { kind: "said", text: "Olá!", block: "b", tick: 30, number: 0 } as const;
    const view = { ...moving("wait", 3, 1), output: { ...IDLE.output, talk: [line] } };
    expect(sentenceOf({ ...view, tick: 60 }, context)?.detail).toBe("Diz: “Olá!”");
    expect(sentenceOf({ ...view, tick: 300 }, context)?.detail).toBe("");
  });

  test.each([
    ["camera", "B", 0.971, "A câmera viu B (97%)"],
    ["camera", "B", 1, "A câmera viu B (99%)"],
    ["taught", "siga", 0.9, "A câmera viu siga, um sinal da turma (90%)"],
    ["person", "B", null, "Vocês responderam B"],
    ["person", "", null, "Vocês responderam: nenhum sinal"],
    ["list", "B", null, "Sinal da lista: B"],
    [null, "", null, "Nenhum sinal visto"],
  ] as const)("the answer of a capture tells who gave it: %s %s", (by, label, confidence, text) => {
    const view = {
      ...moving("wait", 3, 1),
      captured: { what: "sign", label, by, confidence, tick: 30, nextLine: 0 } as const,
    };
    expect(sentenceOf({ ...view, tick: 60 }, context)?.detail).toBe(text);
    expect(sentenceOf({ ...view, tick: 300 }, context)?.detail).toBe("");
    expect(
      sentenceOf({ ...over("finished", {}), ...view, phase: "finished", tick: 30 }, context),
    ).toMatchObject({ detail: text });
  });

  test.each([
    ["camera", "3", 0.991, "A câmera contou 3 (99%)"],
    ["person", "", null, "Vocês responderam: nenhum número (−1)"],
    [null, "", null, "Nenhum número visto (−1)"],
  ] as const)("a number tells who gave it, too: %s %s", (by, label, confidence, text) => {
    const captured = { what: "number", label, by, confidence, tick: 30, nextLine: 0 } as const;
    const view = { ...moving("wait", 3, 1), captured, tick: 60 };
    expect(sentenceOf(view, context)?.detail).toBe(text);
    const capture = { block: "a", timeoutS: 10, leftS: 9, what: "number" } as const;
    expect(sentenceText({ ...command("read_number"), capture })).toBe(
      "Esperando um número mostrado com os dedos",
    );
  });

  test("of what was said and what was answered, the newest is told", () => {
    const line = { kind: "said", text: "Olá!", block: "b", tick: 30, number: 0 } as const;
    const answer = { what: "sign", label: "B", by: "person", confidence: null } as const;
    const captured = { ...answer, tick: 30, nextLine: 1 };
    const view = { ...moving("wait", 3, 1), tick: 40, captured };
    // all in one tick, as when a program refuses a sign and asks again
    const outputWith = (number: number) => ({ ...IDLE.output, talk: [{ ...line, number }] });
    expect(sentenceOf({ ...view, output: outputWith(0) }, context)?.detail).toBe(
      "Vocês responderam B",
    );
    expect(sentenceOf({ ...view, output: outputWith(1) }, context)?.detail).toBe("Diz: “Olá!”");
  });

  test("a beep is told beside what was said, and how many there were in a row", () => {
    const talk = [{ kind: "said", text: "Olá!", block: "b", tick: 30, number: 0 }] as const;
    const beeps = { count: 5, inRow: 2, tick: 35 };
    const view = { ...moving("wait", 3, 1), tick: 40 };
    const detail = (output: object) =>
      sentenceOf({ ...view, output: { ...IDLE.output, ...output } }, context)?.detail;
    expect(detail({ beeps })).toBe("Apito × 2");
    expect(detail({ beeps, talk })).toBe("Diz: “Olá!” · Apito × 2");
    expect(detail({ beeps: { ...beeps, tick: -60 } })).toBe("");
  });

  test("a function that runs is named", () => {
    const output = { ...IDLE.output, calls: [{ function: "lado", block: "c" }] };
    expect(sentenceOf({ ...moving("turn", 90, 1), output }, context)?.detail).toBe(
      "na função “lado”",
    );
  });

  test("a loop without a number of rounds tells its round, unless rounds come too fast to tell", () => {
    const loop = {
      block: "l",
      pointer: "/commands/0",
      action: "while",
      amount: null,
      roundTick: 0,
    };
    const view = (round: number) => ({ ...moving("turn", 90, 1), stack: [{ ...loop, round }] });
    expect(sentenceOf(view(7), context)?.detail).toBe("volta 7");
    expect(sentenceOf(view(Number.NaN), context)?.detail).toBe("");
  });

  test("a loop tells its round", () => {
    const loop = {
      block: "l",
      pointer: "/commands/0",
      action: "repeat",
      amount: null,
      round: 2,
      roundTick: 0,
    };
    const view = { ...moving("turn", 90, 1), stack: [loop] };
    expect(sentenceOf(view, context)?.detail).toBe("volta 2 de 4");
  });

  test("an end tells how far from the start", () => {
    expect(sentenceText(over("finished", {}))).toBe("O programa terminou: o robô voltou à partida");
    expect(sentenceText(over("finished", { closingErrorM: 1.234 }))).toBe(
      "O programa terminou: o robô parou a 1,23 m da partida",
    );
    expect(sentenceText(over("finished", { pathLengthM: 0 }))).toBe("O programa terminou");
  });

  const detail = (view: RunView) => sentenceOf(view, context)?.detail.replaceAll("\u00a0", " ");

  test.each([
    [{ closingErrorM: 0.05, estimatedClosingErrorM: 1e-6 }, "parou a 0,05 m da partida", "voltou"],
    [{ closingErrorM: 0, estimatedClosingErrorM: 0.31 }, "voltou à", "parou a 0,31 m dela"],
    [{ closingErrorM: 0.5, estimatedClosingErrorM: 0.4 }, "a 0,50 m da", "parou a 0,40 m dela"],
  ])("an end tells the truth, and what the robot believes instead: %#", (ending, text, belief) => {
    const view = over("finished", ending);
    expect(sentenceText(view)).toContain(text);
    expect(detail(view)).toContain("O robô pensa que");
    expect(detail(view)).toContain(belief);
  });

  test("a robot that is about where it believes is not said to be wrong", () => {
    const ending = { closingErrorM: 0.502, estimatedClosingErrorM: 0.5 };
    expect(detail(over("finished", ending))).toBe("");
  });

  test.each([
    [0.001, "Pelas medidas do robô, ele voltou à partida."],
    [0.25, "Pelas medidas do robô, ele parou a 0,25 m da partida."],
  ])("what only the robot measured is said to be that: %#", (estimatedClosingErrorM, expected) => {
    const view = over("finished", { closingErrorM: null, estimatedClosingErrorM });
    expect([sentenceText(view), detail(view)]).toEqual(["O programa terminou", expected]);
  });

  test("a failure has the server's words and remedy", () => {
    const sentence = sentenceOf(
      over("failed", { reason: "blocked", params: { done: 3.78, amount: 9 } }),
      context,
    );
    expect(sentence?.tone).toBe("fault");
    expect(sentence?.text).toContain("3,78");
    expect(sentence?.detail).not.toBe("");
  });

  test("an unknown reason still says something", () => {
    expect(sentenceText(over("failed", { reason: "no_such_code" }))).toBe(ptBR.status.failed);
  });
});

test("a parameter is read out of the document", () => {
  const commands = [{ action: "stop" }, { action: "repeat", times: 5, commands: [] }];
  expect(parameterIn({ commands }, "/commands/1", "times")).toBe(5);
  expect(parameterIn(commands, "/commands/1", "times")).toBe(5);
  expect(parameterIn({ commands }, "/commands/9/commands/0", "times")).toBeUndefined();
  expect(parameterIn(null, "/commands/0", "times")).toBeUndefined();
});

describe("of a run that was", () => {
  const past = (view: RunView) => sentenceOf(view, { ...context, past: true });

  test("no button is spoken of that is not there", () => {
    const stopped = over("stopped", { reason: "stopped_by_person" });
    expect(sentenceOf(stopped, context)?.detail).toContain("Rodar");
    expect(past(stopped)).toEqual({ text: "O grupo parou o robô.", detail: "", tone: "notice" });
    const held = { ...moving("wait", 3, 1), phase: "paused", next: "b" } as RunView;
    expect(past(held)).toEqual({ text: "A rodada estava em pausa.", detail: "", tone: "notice" });
  });

  test("what is to be mended is said still", () => {
    const failed = over("failed", { reason: "division_by_zero", params: { operator: "/" } });
    expect(past(failed)).toEqual(sentenceOf(failed, context));
    expect(past(failed)?.detail).not.toBe("");
  });
});

describe("what a program did not do is said at its end, and not as a success", () => {
  const move = { action: "move_forward", distance: 1, block: "m" };
  const stored = (commands: object[], loose: object[] = []) => ({
    document: { commands },
    workspace: { blocks: { blocks: [{ type: "program_start" }, ...loose] } },
  });
  const end = (program: ReturnType<typeof stored>, changes: Partial<RunView> = {}) =>
    sentenceOf({ ...over("finished", {}), ...changes }, { ...context, program });
  const talk = [{ kind: "said", text: "Olá!", block: null, tick: 1, number: 0 }] as const;
  const still = { moved: false, ending: { ...over("finished", {}).ending, pathLengthM: 0 } };

  test("a program without such parts ends well", () => {
    const program = stored([{ action: "repeat", times: 4, commands: [move] }]);
    expect(end(program)).toMatchObject({ tone: "done", detail: "" });
  });

  test("an empty loop, wherever it is", () => {
    const empty = { action: "repeat", times: 4, commands: [] };
    expect(end(stored([move, empty]))).toMatchObject({
      tone: "notice",
      detail: "Há uma repetição vazia: ponham blocos dentro dela.",
    });
    const inside = { action: "conditional_execution", condition: true, else: [empty, empty] };
    expect(end(stored([move, inside]))?.detail).toContain("2 repetições vazias");
  });

  test("loose blocks, each that is not a shadow", () => {
    const one = { type: "turn", inputs: { ANGLE: { shadow: { type: "number" } } } };
    expect(end(stored([move], [one]))).toMatchObject({
      tone: "notice",
      detail: "Um bloco está solto e não rodou.",
    });
    const three = { ...one, next: { block: { ...one, next: { block: one } } } };
    expect(end(stored([move], [three, { type: "function_def" }]))?.detail).toContain("3 blocos");
  });

  test("a robot that stood still, unless the program only speaks", () => {
    const expected = "O programa terminou, mas o robô não saiu do lugar";
    const wait = { action: "wait", seconds: 1 };
    const speech = { action: "say", text: "Olá!" };
    expect(end(stored([wait]), still as Partial<RunView>)).toMatchObject({
      tone: "notice",
      text: expected,
    });
    const spoken = { ...still, output: { ...IDLE.output, talk } } as Partial<RunView>;
    expect(end(stored([speech]), spoken)).toMatchObject({ tone: "done" });
    const unmoved = { action: "conditional_execution", condition: true, else: [move] };
    expect(end(stored([speech, unmoved]), spoken)).toMatchObject({
      tone: "notice",
      text: expected,
    });
    const toPlace = { action: "go_to_place", place: "A" };
    expect(end(stored([speech, toPlace]), spoken)).toMatchObject({
      tone: "notice",
      text: expected,
    });
  });
});
