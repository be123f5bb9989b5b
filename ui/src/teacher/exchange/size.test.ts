import { expect, test } from "vitest";
import { size } from "./size";

test("sizes are told with the unit that suits them", () => {
  expect(size(0, "pt-BR")).toBe("0\u00a0KB");
  expect(size(1, "pt-BR")).toBe("1\u00a0KB");
  expect(size(340_400, "pt-BR")).toBe("340\u00a0KB");
  expect(size(1_230_000_000, "pt-BR")).toBe("1,2\u00a0GB");
  expect(size(999_800, "en")).toBe("1.0\u00a0MB");
  expect(size(64e12, "en")).toBe("64\u00a0TB");
});
