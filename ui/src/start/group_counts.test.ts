import { expect, test } from "vitest";
import type { Group } from "../api/model";
import { textsOf } from "../i18n";
import { groupCounts } from "./group_counts";

const ptBR = textsOf("pt-BR");

const counts = (n_programs: number, n_in_bin: number, n_runs: number) =>
  groupCounts({ n_programs, n_in_bin, n_runs } as Group, ptBR);

test("a group's work is counted with what is in the bin", () => {
  expect(counts(0, 0, 0)).toBe("Ainda sem programas");
  expect(counts(2, 0, 12)).toBe("2 programas · 12 rodadas");
  expect(counts(2, 1, 12)).toBe("2 programas · 1 na lixeira · 12 rodadas");
  expect(counts(0, 1, 12)).toBe("1 programa na lixeira · 12 rodadas");
  expect(counts(0, 0, 1)).toBe("0 programas · 1 rodada");
});
