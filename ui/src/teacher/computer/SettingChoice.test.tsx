import { cleanup, fireEvent, render, screen } from "@testing-library/preact";
import { afterEach, expect, test, vi } from "vitest";
import { passesAxe } from "../../kit/testing/control";
import { setting } from "../../shell/settings";
import { SettingChoice } from "./SettingChoice";

const fetched = vi.fn(async (_request: Request) => new Response("{}"));
vi.stubGlobal("fetch", fetched);
afterEach(cleanup);

const options = { "0": "Never", "5": "Every 5", "10": "Every 10", "15": "Every 15" };
const choice = <SettingChoice name="pinel_turns" title="Turns" hint="A line" options={options} />;

test("the value in force is checked, and another is kept when it is chosen", async () => {
  const { container } = render(choice);
  await passesAxe(container);
  expect(screen.getByLabelText<HTMLInputElement>("Every 10").checked).toBe(false);
  fireEvent.click(screen.getByLabelText("Every 10"));
  expect(setting("pinel_turns").value).toBe("10");
  expect(screen.getByLabelText<HTMLInputElement>("Every 10").checked).toBe(true);
  await vi.waitFor(() => expect(fetched).toHaveBeenCalledOnce());
  const [request] = fetched.mock.calls[0] ?? [];
  expect(await request?.json()).toEqual({ name: "pinel_turns", value: "10" });
});
