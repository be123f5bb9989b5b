import { act, cleanup, fireEvent, render, screen, waitFor } from "@testing-library/preact";
import { afterEach, beforeEach, describe, expect, test, vi } from "vitest";
import type { SignRecordingEvent } from "../api/model";
import { passesAxe } from "../kit/testing/control";

const signsApi = {
  use: vi.fn(),
  list: vi.fn(),
  record: vi.fn(),
  recordMoving: vi.fn(),
  stop: vi.fn(),
  forget: vi.fn(),
};
vi.mock("../api/signs", () => ({ signsApi }));

const classes = vi.fn();
vi.mock("../shell/first_answers", () => ({ groupsAndClasses: classes, serverStatus: vi.fn() }));

const { Teaching } = await import("./Teaching");
const { receive } = await import("../camera/sight");
const { setClassroom } = await import("../shell/classroom");

const A = { name: "A", is_letter: true, n_samples: 0, n_movements: 0, landmarks: null };
const GO = { name: "vai", is_letter: false, n_samples: 10, n_movements: 0, landmarks: null };

const recordingEvent = (more: Partial<SignRecordingEvent>): SignRecordingEvent => ({
  type: "sign_recording",
  classroom: "c",
  sign: "vai",
  is_moving: false,
  n_samples: 3,
  n_wanted: 10,
  is_kept: false,
  code: null,
  params: {},
  message: "",
  remedy: "",
  ...more,
});

beforeEach(() => {
  setClassroom("");
  classes.mockReset().mockResolvedValue([[], [{ id: "c", name: "5º B" }]]);
  signsApi.use.mockReset().mockResolvedValue([A, GO]);
  signsApi.record.mockReset().mockResolvedValue({ name: "vai" });
  signsApi.recordMoving.mockReset().mockResolvedValue({ name: "J" });
  signsApi.stop.mockReset().mockResolvedValue({});
  signsApi.forget.mockReset().mockResolvedValue({});
  signsApi.list.mockReset().mockResolvedValue([A, GO]);
});
afterEach(cleanup);

const status = () => screen.getByTestId("teach-told").textContent;
const taught = () => screen.queryAllByTestId("taught-sign").map((one) => one.dataset.sign);

describe("teaching a sign", () => {
  test("is for a class", async () => {
    classes.mockResolvedValue([[], []]);
    const { container } = render(<Teaching />);
    await act(async () => {});
    expect(container.textContent).toBe("");
    expect(signsApi.use.mock.calls).toEqual([[null]]);
  });

  test("begins with its name, counts what is recorded, and says when the camera knows it", async () => {
    const { container } = render(<Teaching />);
    await waitFor(() => expect(taught()).toEqual(["vai"]));
    fireEvent.input(screen.getByTestId("teach-name"), { target: { value: " vai " } });
    fireEvent.click(screen.getByTestId("teach-record"));
    await waitFor(() => expect(signsApi.record).toHaveBeenCalledWith("c", "vai"));
    act(() => receive(recordingEvent({})));
    expect(status()).toContain("3 de 10");
    act(() => receive(recordingEvent({ n_samples: 10, is_kept: true })));
    expect(status()).toContain("vai");
    await passesAxe(container);
  });

  test("shows what the class has now whenever it is told that this is something else", async () => {
    render(<Teaching />);
    await waitFor(() => expect(taught()).toEqual(["vai"]));
    signsApi.list.mockResolvedValue([A, GO, { ...GO, name: "7" }]);
    act(() => receive({ type: "signs_changed", classroom: "other" }));
    act(() => receive({ type: "signs_changed", classroom: "c" }));
    await waitFor(() => expect(taught()).toEqual(["vai", "7"]));
    expect(signsApi.list.mock.calls).toEqual([["c"]]);
  });

  test("of a letter that moves records movements, and says how to make them", async () => {
    const J = { name: "J", is_letter: false, n_samples: 0, n_movements: 5, landmarks: null };
    signsApi.use.mockResolvedValue([A, J]);
    const { container } = render(<Teaching />);
    await waitFor(() => expect(taught()).toEqual(["J"]));
    expect(screen.getByText("5 movimentos")).toBeTruthy();
    fireEvent.click(screen.getByRole("button", { name: "J" }));
    expect(container.textContent).toContain("isto cinco vezes");
    fireEvent.click(screen.getByTestId("teach-record"));
    await waitFor(() => expect(signsApi.recordMoving).toHaveBeenCalledWith("c", "J"));
    act(() => receive(recordingEvent({ sign: "J", is_moving: true, n_samples: 2, n_wanted: 5 })));
    expect(status()).toContain("J: 2 de 5. Parem a mão");
    await passesAxe(container);
  });

  test("of Y and of any name chosen so records a hand at rest", async () => {
    render(<Teaching />);
    await screen.findByTestId("teach-told");
    fireEvent.click(screen.getByRole("button", { name: "Z" }));
    fireEvent.click(screen.getByRole("button", { name: "Y" }));
    fireEvent.click(screen.getByTestId("teach-record"));
    await waitFor(() => expect(signsApi.record).toHaveBeenCalledWith("c", "Y"));
    fireEvent.click(screen.getByRole("button", { name: "Se mexe (experimental)" }));
    fireEvent.click(screen.getByTestId("teach-record"));
    await waitFor(() => expect(signsApi.recordMoving).toHaveBeenCalledWith("c", "Y"));
    fireEvent.click(screen.getByRole("button", { name: "Ç" }));
    fireEvent.click(screen.getByTestId("teach-record"));
    await waitFor(() => expect(signsApi.recordMoving).toHaveBeenCalledWith("c", "Ç"));
  });

  test("says why it was given up", async () => {
    render(<Teaching />);
    await screen.findByTestId("teach-told");
    act(() =>
      receive(recordingEvent({ code: "x", message: "Sem mão.", remedy: "Mostrem a mão." })),
    );
    expect(status()).toBe("Sem mão. Mostrem a mão.");
    act(() =>
      receive(recordingEvent({ code: "sign_recording_stopped", message: "No hand.", remedy: "" })),
    );
    expect(status()).toContain("Não deu para ver a mão parada.");
    act(() => receive(recordingEvent({ classroom: "other" })));
    expect(status()).toBe("");
  });

  test("is taken back", async () => {
    render(<Teaching />);
    signsApi.list.mockResolvedValue([A]);
    fireEvent.click(await screen.findByTestId("forget-sign"));
    await waitFor(() => expect(signsApi.forget).toHaveBeenCalledWith("c", "vai"));
    act(() => receive({ type: "signs_changed", classroom: "c" }));
    await waitFor(() => expect(taught()).toEqual([]));
  });

  test("stops with the screen", async () => {
    const { unmount } = render(<Teaching />);
    await waitFor(() => expect(signsApi.use).toHaveBeenCalled());
    unmount();
    expect(signsApi.stop).toHaveBeenCalled();
  });
});
