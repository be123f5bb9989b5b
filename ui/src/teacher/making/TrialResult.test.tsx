import { cleanup, render } from "@testing-library/preact";
import { afterEach, beforeAll, test } from "vitest";
import type { Trial } from "../../api/model";
import { setLanguage, texts } from "../../i18n";
import { TrialResult } from "./TrialResult";

beforeAll(() => setLanguage("pt-BR"));
afterEach(cleanup);

const trial = (program: "solution" | "empty", preset: string, is_right: boolean): Trial => ({
  program,
  preset,
  is_right,
  passed: is_right === (program === "solution"),
  words: "",
});

test.each([
  [["empty ideal", "empty realistic"], "emptyPasses"],
  [["solution realistic"], "onlyIdeal"],
  [["solution ideal", "empty ideal"], "wrong"],
  [[], "right"],
] as const)("with %j wrong, the result says what to do: %s", (wrong, key) => {
  const trials = (["solution", "empty"] as const).flatMap((program) =>
    ["ideal", "realistic"].map((preset) =>
      trial(program, preset, !(wrong as readonly string[]).includes(`${program} ${preset}`)),
    ),
  );
  const { getByText } = render(<TrialResult trials={{ faults: [], trials }} />);
  getByText(texts.value.making.trial[key]);
});
