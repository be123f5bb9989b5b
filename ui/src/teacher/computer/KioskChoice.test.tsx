import { cleanup, fireEvent, render } from "@testing-library/preact";
import { afterEach, beforeAll, expect, test, vi } from "vitest";
import type { KioskState } from "../../api/model";
import { fetchLazyTexts, texts } from "../../i18n";
import { passesAxe } from "../../kit/testing/control";
import { KioskChoice } from "./KioskChoice";

const OFF: KioskState = {
  is_active: false,
  is_chosen: false,
  is_by_command: false,
  has_window: true,
};
let state = OFF;
const fetched = vi.fn(async (request: Request) => {
  if (request.method === "PUT") state = { ...state, ...(await request.clone().json()) };
  return new Response(JSON.stringify(state));
});
vi.stubGlobal("fetch", fetched);

beforeAll(fetchLazyTexts);
afterEach(() => {
  cleanup();
  fetched.mockClear();
  state = OFF;
});

test("the choice is sent", async () => {
  const { container, findByTestId } = render(<KioskChoice />);
  const box = (await findByTestId("kiosk")) as HTMLInputElement;
  expect(box.checked).toBe(false);
  await passesAxe(container);
  fireEvent.click(box);
  await vi.waitFor(() => expect(fetched).toHaveBeenCalledTimes(2));
  expect(await fetched.mock.calls[1]?.[0].json()).toEqual({ is_chosen: true });
});

test("in kiosk mode, the teacher can close PINEL", async () => {
  state = { ...OFF, is_active: true, is_chosen: true };
  const { findByTestId } = render(<KioskChoice />);
  fireEvent.click(await findByTestId("kiosk-leave"));
  await vi.waitFor(() => expect(fetched).toHaveBeenCalledTimes(2));
  expect(new URL(fetched.mock.calls[1]?.[0].url ?? "").pathname).toBe("/api/kiosk/leave");
});

test("what the system decides cannot be changed here, and the page says so", async () => {
  state = { ...OFF, is_active: true, is_by_command: true };
  const { findByTestId, getByText } = render(<KioskChoice />);
  const box = (await findByTestId("kiosk")) as HTMLInputElement;
  expect([box.checked, box.disabled]).toEqual([true, true]);
  getByText(texts.value.kiosk.byCommand);
});
