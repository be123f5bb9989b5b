import { cleanup, fireEvent, render, screen, waitFor } from "@testing-library/preact";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import type { OverheadCamera, OverheadSighting } from "../../../api/model";
import { passesAxe } from "../../../kit/testing/control";

const overheadApi = {
  get: vi.fn(),
  save: vi.fn(),
  switchOff: vi.fn(),
  sheets: vi.fn(),
  tryOut: vi.fn(),
  endTrial: vi.fn(),
};
vi.mock("../../../api/real_runs", () => ({ overheadApi }));
vi.mock("../../../camera/CameraPicture", () => ({ CameraPicture: () => null }));
vi.mock("../../../camera/CameraChoice", () => ({ CameraChoice: () => null }));

const { OverheadPart } = await import("./OverheadPart");

const OFF: OverheadCamera = { is_on: false, width_m: 3, depth_m: 3, camera_m: 2.7, robot_m: 0.25 };
const SIGHTING: OverheadSighting = {
  code: "overhead_seen",
  params: {},
  message: "Robô: x 1,0 m.",
  remedy: "",
  markers: [1, 2, 4, 5],
};

beforeEach(() => {
  for (const ask of Object.values(overheadApi)) ask.mockReset();
  overheadApi.get.mockResolvedValue(OFF);
  overheadApi.save.mockImplementation(async (measures) => ({ ...measures, is_on: true }));
  overheadApi.tryOut.mockResolvedValue(SIGHTING);
  overheadApi.endTrial.mockResolvedValue({});
});
afterEach(cleanup);

const measure = (name: string) =>
  screen
    .getAllByTestId<HTMLInputElement>("overhead-measure")
    .find((field) => field.dataset.name === name) as HTMLInputElement;
const save = () => fireEvent.click(screen.getByTestId("overhead-save"));

test("measures are typed as people write them, and switch the camera on", async () => {
  const { container } = render(<OverheadPart />);
  await screen.findByTestId("overhead-save");
  expect(screen.queryByTestId("overhead-try")).toBeNull();
  fireEvent.input(measure("width"), { target: { value: "muito" } });
  save();
  expect((await screen.findByRole("alert")).textContent).toContain("Escreva um número.");
  expect(overheadApi.save).not.toHaveBeenCalled();
  fireEvent.input(measure("width"), { target: { value: "2,5" } });
  save();
  await screen.findByTestId("overhead-try");
  expect(overheadApi.save).toHaveBeenCalledWith({
    width_m: 2.5,
    depth_m: 3,
    camera_m: 2.7,
    robot_m: 0.25,
  });
  await passesAxe(container);
});

test("a trial tells which sheets are seen and where the robot is, and ends", async () => {
  overheadApi.get.mockResolvedValue({ ...OFF, is_on: true });
  render(<OverheadPart />);
  fireEvent.click(await screen.findByTestId("overhead-try"));
  await waitFor(() =>
    expect(screen.getByTestId("overhead-found").textContent).toContain("Robô: x 1,0 m."),
  );
  const seen = screen.getAllByTestId("overhead-sheet").map(({ dataset }) => dataset.seen);
  expect(seen).toEqual(["true", "true", "false", "true", "true"]);
  fireEvent.click(screen.getByTestId("overhead-try"));
  await waitFor(() => expect(overheadApi.endTrial).toHaveBeenCalled());
});
