import { describe, expect, test } from "vitest";
import { OWN_WORLD, type Setup, type VersionSummary, type World } from "../api/model";
import { textsOf } from "../i18n";
import { worlds } from "../shell/session";
import { setupOf } from "../studio/program/setup";
import { setupFacts } from "./setup_texts";
import { stepText } from "./version_texts";

const PT = textsOf("pt-BR");
const AT_FIRST = setupOf(null);

worlds.value = [
  { name: "empty_room", title: { "pt-BR": "Sala vazia" } },
  { name: "maze", title: { "pt-BR": "Labirinto" } },
] as unknown as World[];

function version(setup: Partial<Setup>, more: Partial<VersionSummary> = {}): VersionSummary {
  return {
    id: "v",
    number: 2,
    created_at: "2026-10-05T15:00:00Z",
    can_run: true,
    label: "",
    parent_id: "u",
    lesson_id: null,
    computer: null,
    n_runs: 0,
    n_passed: 0,
    setup: { ...AT_FIRST, ...setup },
    setup_only: true,
    ...more,
  };
}

function stepTextOf(versions: VersionSummary[], before = version({})) {
  const last = versions[versions.length - 1] as VersionSummary;
  const setup = setupFacts(before, last, PT, "pt-BR");
  return stepText({ kind: "step", versions }, setup, PT);
}

describe("a step of the history", () => {
  test("says what changed of the setup in place of a change of blocks that was none", () => {
    expect(stepTextOf([version({ world: "maze" })])).toEqual({
      label: "Mundo: Labirinto",
      facts: [],
    });
    expect(stepTextOf([version({ n_hints: 1 }), version({ n_hints: 1, speed: 2 })]).label).toBe(
      "Velocidade: 2× · Dica 1 aberta",
    );
    expect(stepTextOf([version({ n_hints: 3 })], version({ n_hints: 1 })).label).toBe(
      "Dicas 2 a 3 abertas",
    );
  });

  test("counts only the versions that changed blocks, and names the setup besides", () => {
    const versions = [version({}, { setup_only: false }), version({ n_hints: 2 })];
    expect(stepTextOf(versions)).toEqual({ label: "1 mudança", facts: ["Dicas 1 a 2 abertas"] });
  });

  test("has words where no part with a name differs", () => {
    const own = version({ world: OWN_WORLD });
    expect(stepTextOf([own], own).label).toBe("Mundo: Nosso mundo");
    expect(stepTextOf([version({})], version({}, { setup: null })).label).toBe("Onde e como roda");
  });

  test("that ran or has a name keeps that as its label", () => {
    expect(stepTextOf([version({ world: "maze" }, { label: "anda" })])).toEqual({
      label: "anda",
      facts: ["Mundo: Labirinto"],
    });
    expect(stepTextOf([version({ n_hints: 1 }, { n_passed: 1, n_runs: 1 })])).toEqual({
      label: "cumpriu a missão",
      facts: ["Dica 1 aberta"],
    });
  });
});
