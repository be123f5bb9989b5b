import { fireEvent, render, waitFor } from "@testing-library/preact";
import { expect, test, vi } from "vitest";
import { Form } from "./Form";
import { reportTo } from "./report";

test("a form is sent to the page and not to the server, and what fails is reported", async () => {
  const shown = vi.fn();
  reportTo(shown);
  const { container } = render(
    <Form class="add" testId="adds" onSubmit={() => Promise.reject(new Error("full"))} />,
  );
  const form = container.firstElementChild as HTMLFormElement;
  expect([form.className, form.dataset.testid]).toEqual(["add", "adds"]);
  expect(fireEvent.submit(form)).toBe(false);
  await waitFor(() => expect(shown).toHaveBeenCalledWith(new Error("full")));
});
