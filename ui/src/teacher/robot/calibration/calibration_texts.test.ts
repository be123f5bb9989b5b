import { expect, it } from "vitest";
import type { CalibratedParameter, Calibration } from "../../../api/model";
import { texts } from "../../../i18n";
import { findings, heldOutText, interval, squaresText, unknowns } from "./calibration_texts";

function parameter(name: string, value: number, nominal: number, is_known = true) {
  const [low, high] = [value - 0.002, value + 0.002];
  return { name, value, low, high, nominal, is_known, sources: [] };
}

function calibration(parameters: CalibratedParameter[]): Calibration {
  const held_out: Calibration["held_out"] = [
    { place: 0, error_m: 0.02, expected_m: 0.03, nominal_m: 0.2, off_m: [0.02, 0] },
  ];
  return { model: "pioneer_3dx", runs: ["a"], values: {}, parameters, held_out, squares: null };
}

const { calibration: labels } = texts.value;

it("says in words which wheel is larger and how far the robot turns", () => {
  const found = calibration([
    parameter("track_m", 0.345, 0.33),
    parameter("wheel_bias_left", 0.012, 0),
    parameter("wheel_bias_right", -0.008, 0),
  ]);
  expect(findings(found, labels, "pt-BR")).toEqual([
    labels.leftLarger({ percent: "2,0" }),
    labels.fartherPerMetre({ cm: "0,2" }),
    labels.turnsLess({ angle: "15,7" }),
  ]);
  expect(unknowns(found, labels)).toEqual([]);
});

it("names what the runs do not tell, and says nothing of it", () => {
  const found = calibration([parameter("track_m", 0.33, 0.33, false)]);
  expect(findings(found, labels, "pt-BR")).toEqual([]);
  expect(unknowns(found, labels)).toEqual([labels.parameters.track_m]);
});

it("shows an interval in the unit of its parameter, and the prediction of held-out runs", () => {
  expect(interval(parameter("track_m", 0.345, 0.33), labels, "pt-BR")).toBe(
    labels.interval({ value: "0,345 m", low: "0,343 m", high: "0,347 m", nominal: "0,330 m" }),
  );
  const text = labels.heldOut({ error: "2,0", expected: "3,0", nominal: "20,0" });
  expect(heldOutText(calibration([]), labels, "pt-BR")).toBe(text);
  expect(heldOutText({ ...calibration([]), held_out: [] }, labels, "pt-BR")).toBeNull();
});

it("says what UMBmark finds before the calibration and what is left after it", () => {
  const squares = { difference: 0, track_ratio: 1, worst_m: 0.312, n_left: 3, n_right: 4 };
  const text = squaresText({ ...squares, left_over_m: 0.021 }, labels, "pt-BR");
  expect(text).toContain("3 quadrados para a esquerda e 4 para a direita");
  expect(text).toContain("31,2 cm");
  expect(text).toContain("sobram 2,1 cm");
  expect(squaresText({ ...squares, left_over_m: null }, labels, "pt-BR")).not.toContain("sobram");
});
