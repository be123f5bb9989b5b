import { cleanup, render } from "@testing-library/preact";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { usePolling } from "./usePolling";

const poll = vi.fn();
let isHidden = false;

function Poller(polling: Parameters<typeof usePolling>[1]) {
  usePolling(poll, { everyMs: 1000, ...polling });
  return null;
}

function setHidden(hidden: boolean): void {
  isHidden = hidden;
  document.dispatchEvent(new Event("visibilitychange"));
}

beforeEach(() => {
  vi.useFakeTimers();
  vi.spyOn(document, "hidden", "get").mockImplementation(() => isHidden);
  setHidden(false);
  poll.mockClear();
});

afterEach(() => {
  cleanup();
  vi.restoreAllMocks();
  vi.useRealTimers();
});

test("looks at its interval, until it is off or gone", () => {
  const { rerender, unmount } = render(<Poller />);
  expect(poll).toHaveBeenCalledTimes(0);
  vi.advanceTimersByTime(2500);
  expect(poll).toHaveBeenCalledTimes(2);
  rerender(<Poller isOn={false} />);
  vi.advanceTimersByTime(5000);
  expect(poll).toHaveBeenCalledTimes(2);
  rerender(<Poller />);
  vi.advanceTimersByTime(1000);
  unmount();
  vi.advanceTimersByTime(5000);
  expect(poll).toHaveBeenCalledTimes(3);
});

test("rests while the page is hidden, and looks at once when it is shown again", () => {
  render(<Poller />);
  setHidden(true);
  vi.advanceTimersByTime(5000);
  expect(poll).toHaveBeenCalledTimes(0);
  setHidden(false);
  expect(poll).toHaveBeenCalledTimes(1);
});

test("goes on while the page is hidden where that is asked for", () => {
  render(<Poller evenHidden />);
  setHidden(true);
  vi.advanceTimersByTime(2000);
  expect(poll).toHaveBeenCalledTimes(2);
});
