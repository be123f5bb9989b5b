import { cleanup, render, screen } from "@testing-library/preact";
import { afterEach, expect, test, vi } from "vitest";
import { passesAxe } from "../../kit/testing/control";

const noticesApi = { text: vi.fn() };
vi.mock("../../api/notices", () => ({ noticesApi }));

const { NoticesScreen } = await import("./NoticesScreen");

afterEach(cleanup);

test("the works of others in the package are listed, and the text scrolls by keyboard", async () => {
  noticesApi.text.mockResolvedValue("Flask 3.1: BSD-3-Clause\n");
  const { container } = render(<NoticesScreen />);
  const list = await screen.findByTestId("notices");
  expect(list.textContent).toContain("Flask 3.1: BSD-3-Clause");
  expect(list.tabIndex).toBe(0);
  await passesAxe(container);
});

test("without a package, it says where the list is made", async () => {
  noticesApi.text.mockResolvedValue("");
  render(<NoticesScreen />);
  expect((await screen.findByTestId("notices-missing")).textContent).toContain("make package");
});
