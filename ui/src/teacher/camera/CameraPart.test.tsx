import { act, cleanup, render, screen } from "@testing-library/preact";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { changed, hand, sightOf } from "../../camera/testing/camera_events";
import { passesAxe } from "../../kit/testing/control";

const cameraApi = { status: vi.fn() };
const recognizersApi = { list: () => new Promise(() => {}) };
vi.mock("../../api/camera", () => ({ cameraApi, recognizersApi, previewAddress: () => "" }));

const { CameraPart } = await import("./CameraPart");
const { receive } = await import("../../camera/sight");

beforeEach(() => {
  cameraApi.status.mockReturnValue(new Promise(() => {}));
  receive(changed("on"));
});
afterEach(() => {
  cleanup();
  receive(changed("off"));
});

const findings = () => screen.getAllByTestId("camera-point").map((one) => one.dataset.finding);
const isReady = () => screen.getByTestId("camera-ready").dataset.ready;
/** A hand with a height of `part`, as a fraction of the picture's height. */
const tall = (part: number, top = 0.05) =>
  hand({ points: Array.from({ length: 21 }, (_, n) => [0.5, top + (part * n) / 20]) });

test("the camera is ready when a sign was read, and stays so when the hand is put down", async () => {
  const { container } = render(<CameraPart />);
  expect(findings()).toEqual(["good", "good", "open", "open"]);
  expect(isReady()).toBe("false");
  act(() => receive(sightOf(tall(0.5))));
  expect(isReady()).toBe("true");
  expect(screen.getByText("Letra ou sinal visto: B")).toBeTruthy();
  act(() => receive(sightOf()));
  expect(isReady()).toBe("true");
  await passesAxe(container);
});

test.each([
  ["far", tall(0.1)],
  ["near", tall(0.9)],
  ["near", tall(0.5, -0.1)],
])("a hand that is %s is told", (finding, one) => {
  render(<CameraPart />);
  act(() => receive(sightOf(one)));
  expect(findings()[2]).toBe(finding);
  expect(isReady()).toBe("false");
});

test.each([
  ["camera_missing", ["missing", "open", "open", "open"]],
  ["camera_busy", ["missing", "open", "open", "open"]],
  ["camera_frozen", ["frozen", "open", "open", "open"]],
  ["camera_dark", ["good", "dark", "open", "open"]],
  ["camera_black", ["good", "dark", "open", "open"]],
])("what is wrong is in the list, with what to do beside it: %s", async (code, expected) => {
  const { container } = render(<CameraPart />);
  act(() => receive(sightOf(tall(0.5))));
  act(() => receive(changed("failed", code)));
  act(() => receive(sightOf()));
  expect(findings()).toEqual(expected);
  expect(isReady()).toBe("false");
  expect(screen.getByTestId("camera-trouble").dataset.code).toBe(code);
  await passesAxe(container);
});
