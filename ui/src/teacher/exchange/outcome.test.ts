import { expect, test } from "vitest";
import { textsOf } from "../../i18n";
import { outcome } from "./outcome";

const none = { groups: 0, programs: 0, versions: 0, runs: 0 };
const file = {
  computer: "PC 7",
  name: "PC 7-2026-11-21.pinel",
  added: none,
  anonymous: false,
  held_back: null,
  nothing_new: true,
  removed: null,
};
const words = (change: Partial<Parameters<typeof outcome>[0]>) =>
  outcome({ ...file, ...change }, textsOf("pt-BR").exchange);
const work = { groups: 1, programs: 2, versions: 5, runs: 1 };

test("what came is counted", () => {
  expect(words({ added: work, nothing_new: false })).toBe(
    "PC 7: 1 grupo, 2 programas, 5 versões, 1 rodada.",
  );
  expect(words({})).toBe("PC 7: nada novo, já estava tudo aqui.");
  expect(words({ nothing_new: false })).toBe("PC 7: nomes e ajustes atualizados.");
});

test("what was deleted for good does not come back, and is not said to be here", () => {
  expect(words({ held_back: { ...none, groups: 6, runs: 3 } })).toBe(
    "PC 7: nada novo. Não volta, porque foi apagado para sempre: 6 grupos, 3 rodadas.",
  );
  const partly = words({ added: work, nothing_new: false, held_back: { ...none, runs: 1 } });
  expect(partly).toMatch(/^PC 7: 1 grupo.* Não volta, porque foi apagado para sempre: 1 rodada\.$/);
  expect(words({ held_back: none })).toMatch(/^PC 7: nada novo\. Uma parte/);
});

test("what is deleted now is counted, without its versions", () => {
  expect(words({ removed: work, nothing_new: false })).toBe(
    "Apagado: 1 grupo, 2 programas, 1 rodada.",
  );
  expect(words({ removed: none, nothing_new: false })).toBe("Apagado aqui também.");
});

test("groups without names are told as such when they come", () => {
  const came = { anonymous: true, added: work, nothing_new: false };
  expect(words(came)).toContain("“Grupo 1”");
  expect(words({ anonymous: true })).not.toContain("“Grupo 1”");
});
