import { describe, expect, it } from "vitest";
import type { TruthList } from "../api/model";
import { textsOf } from "../i18n";
import { followedSentences, placeText, truthSentences } from "./words";

const texts = textsOf("pt-BR");
const place = (x_m: number, y_m: number, degrees = 0) =>
  placeText({ x_m, y_m, heading_rad: (degrees * Math.PI) / 180 }, texts.truth, "pt-BR").replaceAll(
    "\u00a0",
    " ",
  );

describe("a place in words", () => {
  it("is told from the start mark, as a person measures", () => {
    expect(place(1.02, 0.03)).toBe("1,02 m à frente, 3 cm à esquerda, virado para a frente");
    expect(place(-0.4, -1.5, -12)).toBe("40 cm atrás, 1,50 m à direita, virado 12° para a direita");
    expect(place(0.001, 0, 90)).toBe("na marca da partida, virado 90° para a esquerda");
  });
});

it("names the source and what the robot believed", () => {
  const pose = { tick: null, x_m: 1.02, y_m: 0.03, heading_rad: 0, sigma_m: 0.01, sigma_rad: 0.03 };
  const list: TruthList = {
    truths: [{ source: "tape", measured_at: "", poses: [pose], covered_s: 0 }],
    run_s: 10,
    believed: { x_m: 1.05, y_m: 0, heading_rad: 0 },
  };
  const [first] = truthSentences(list, texts, "pt-BR");
  expect(first?.text.replaceAll("\u00a0", " ")).toBe(
    "Medido com a fita: 1,02 m à frente, 3 cm à esquerda, virado para a frente. " +
      "O robô acreditava estar 1,05 m à frente, virado para a frente: 4 cm de diferença.",
  );
});

it("tells for how long of the run a camera saw the robot", () => {
  const pose = { tick: 9, x_m: 0, y_m: 0, heading_rad: 0, sigma_m: 0.01, sigma_rad: 0.03 };
  const camera = { source: "camera", measured_at: "", poses: [pose], covered_s: 12 } as const;
  const list: TruthList = { truths: [{ ...camera, poses: [pose] }], run_s: 15, believed: null };
  const [first] = truthSentences(list, texts, "pt-BR");
  expect(first?.text.replaceAll("\u00a0", " ")).toBe(
    "Visto pela câmera do teto: na marca da partida, virado para a frente. " +
      "A câmera viu o robô em 12,0 s dos 15,0 s da rodada.",
  );
});

it("tells what went wrong with a source during the run", () => {
  const problems = ["A câmera do teto se mexeu."];
  const followed = { run: "r", problem: "", problems, source: "camera", state: "nothing" } as const;
  expect(followedSentences([followed], texts)).toEqual([
    "A câmera do teto não viu o robô nesta rodada.",
    "Durante a rodada: A câmera do teto se mexeu.",
  ]);
});
