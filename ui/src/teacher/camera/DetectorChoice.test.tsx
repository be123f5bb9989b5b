import { cleanup, fireEvent, render, screen, waitFor } from "@testing-library/preact";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { ApiError } from "../../api/errors";
import type { Recognizers } from "../../api/model";
import { passesAxe } from "../../kit/testing/control";

const recognizersApi = { list: vi.fn(), choose: vi.fn(), add: vi.fn(), remove: vi.fn() };
vi.mock("../../api/camera", () => ({ recognizersApi }));

const { DetectorChoice } = await import("./DetectorChoice");

const known = (more: Partial<Recognizers> = {}): Recognizers => ({
  chosen: "",
  in_use: "",
  of_command: null,
  detectors: [],
  signs: [],
  problem: null,
  ...more,
});
const ANA = known({ chosen: "ana", in_use: "ana", detectors: ["ana"], signs: ["A", "B"] });

beforeEach(() => {
  for (const ask of Object.values(recognizersApi)) ask.mockReset();
  recognizersApi.list.mockResolvedValue(known());
});
afterEach(cleanup);

const choice = () => screen.getByTestId<HTMLSelectElement>("detector-choice");

test("a detector from a file is used, and its signs are named", async () => {
  recognizersApi.add.mockResolvedValue(ANA);
  const { container } = render(<DetectorChoice />);
  await waitFor(() => expect(choice().value).toBe(""));
  const file = new File(["onnx"], "ana.onnx");
  fireEvent.change(screen.getByTestId("detector-file"), { target: { files: [file] } });
  await waitFor(() => expect(choice().value).toBe("ana"));
  expect(recognizersApi.add).toHaveBeenCalledWith(file);
  expect(screen.getByTestId("detector-signs").textContent).toContain("A, B");
  await passesAxe(container);
});

test("a file that is no detector is explained, and the choice stays", async () => {
  recognizersApi.add.mockRejectedValue(
    new ApiError(422, {
      code: "detector_unreadable",
      message: "Não é um detector.",
      remedy: "Exporte de novo.",
    }),
  );
  render(<DetectorChoice />);
  await waitFor(choice);
  fireEvent.change(screen.getByTestId("detector-file"), {
    target: { files: [new File([], "x.onnx")] },
  });
  expect((await screen.findByRole("alert")).textContent).toContain("Exporte de novo.");
  expect(choice().value).toBe("");
});

test("the chosen detector can be removed", async () => {
  recognizersApi.list.mockResolvedValue(ANA);
  recognizersApi.remove.mockResolvedValue(known());
  render(<DetectorChoice />);
  fireEvent.click(await screen.findByTestId("detector-remove"));
  await waitFor(() => expect(choice().value).toBe(""));
  expect(recognizersApi.remove).toHaveBeenCalledWith("ana");
  expect(screen.queryByTestId("detector-remove")).toBeNull();
});

test("a recognizer of the command line is named and leaves nothing to choose", async () => {
  recognizersApi.list.mockResolvedValue(known({ of_command: "yolo:best.onnx" }));
  render(<DetectorChoice />);
  expect((await screen.findByTestId("detector-of-command")).textContent).toContain(
    "yolo:best.onnx",
  );
  expect(screen.queryByTestId("detector-choice")).toBeNull();
});
