import { expect, test } from "vitest";
import { textsOf } from "../../i18n";
import { newsOf, outcome } from "./outcome";

const none = { groups: 0, programs: 0, versions: 0, runs: 0 };
const file = {
  computer: "PC 7",
  name: "PC 7-2026-11-21.pinel",
  added: none,
  anonymous: false,
  held_back: null,
  kept: [],
  nothing_new: true,
  removed: null,
};
const outcomeText = (change: Partial<Parameters<typeof outcome>[0]>) =>
  outcome({ ...file, ...change }, textsOf("pt-BR").exchange);
const work = { groups: 1, programs: 2, versions: 5, runs: 1 };

test("what came is counted", () => {
  expect(outcomeText({ added: work, nothing_new: false })).toBe(
    "PC 7: 1 grupo, 2 programas, 5 versões, 1 rodada.",
  );
  expect(outcomeText({})).toBe("PC 7: nada de novo, já estava tudo aqui.");
  expect(outcomeText({ nothing_new: false })).toBe("PC 7: nomes e ajustes atualizados.");
});

test("what was deleted for good does not come back, and is not said to be here", () => {
  expect(outcomeText({ held_back: { ...none, groups: 6, runs: 3 } })).toBe(
    "PC 7: nada de novo. Não volta, porque foi apagado para sempre: 6 grupos, 3 rodadas.",
  );
  const partly = outcomeText({ added: work, nothing_new: false, held_back: { ...none, runs: 1 } });
  expect(partly).toMatch(/^PC 7: 1 grupo.* Não volta, porque foi apagado para sempre: 1 rodada\.$/);
  expect(outcomeText({ held_back: none })).toMatch(/^PC 7: nada de novo\. Uma parte/);
});

test("what is deleted now is counted, without its versions", () => {
  expect(outcomeText({ removed: work, nothing_new: false })).toBe(
    "Apagado: 1 grupo, 2 programas, 1 rodada.",
  );
  expect(outcomeText({ removed: none, nothing_new: false })).toBe("Apagado aqui também.");
});

test("groups without names are told as such when they come", () => {
  const came = { anonymous: true, added: work, nothing_new: false };
  expect(outcomeText(came)).toContain("“Grupo 1”");
  expect(outcomeText({ anonymous: true })).not.toContain("“Grupo 1”");
});

test("what was kept is told by name", () => {
  expect(outcomeText({ kept: ["Onças"], nothing_new: false })).toBe(
    "Mantido em todos os computadores: Onças.",
  );
});

test("what was moved or is newer is told with numbers", () => {
  const texts = textsOf("pt-BR").exchange;
  const work = {
    ...{ kind: "group" as const, id: "1", name: "Onças", place: "9º B", is_moved: true },
    ...{ is_newer: true, n_programs: 2, n_runs: 3 },
    ...{ n_new_programs: 1, n_new_edits: 0, n_new_runs: 2 },
  };
  expect(newsOf(work, texts)).toBe(
    "Está agora na turma 9º B. Mais novo aqui: 1 programa, 2 rodadas.",
  );
  expect(newsOf({ ...work, place: "", n_new_programs: 0, n_new_runs: 0 }, texts)).toBe(
    "Está agora sem turma.",
  );
  expect(newsOf({ ...work, is_moved: false, n_new_programs: 0, n_new_runs: 0 }, texts)).toBe("");
});
