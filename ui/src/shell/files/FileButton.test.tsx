import { cleanup, fireEvent, render } from "@testing-library/preact";
import { afterEach, expect, test, vi } from "vitest";
import { reportTo } from "../../kit/report";
import { passesAxe } from "../../kit/testing/control";
import { driveRequest } from "./drive_request";
import { FileButton } from "./FileButton";

afterEach(() => {
  cleanup();
  delete document.documentElement.dataset.kiosk;
});

test("a button for files hands over the file that is chosen, and reports what fails", async () => {
  const report = vi.fn();
  reportTo(report);
  const lost = new Error("lost");
  const onFile = vi.fn(() => Promise.reject(lost));
  const { container, getByRole, getByTestId } = render(
    <FileButton accept=".pinel" testId="file" onFile={onFile}>
      Trazer
    </FileButton>,
  );
  const input = getByTestId("file") as HTMLInputElement;
  const click = vi.spyOn(input, "click");
  fireEvent.click(getByRole("button", { name: "Trazer" }));
  expect(click).toHaveBeenCalledOnce();
  const file = new File(["{}"], "a.pinel");
  fireEvent.change(input, { target: { files: [file] } });
  expect(onFile).toHaveBeenCalledWith(file);
  await vi.waitFor(() => expect(report).toHaveBeenCalledWith(lost));
  await passesAxe(container);
});

test("in kiosk mode, it asks for a file on a drive instead", () => {
  document.documentElement.dataset.kiosk = "1";
  const onFile = vi.fn();
  const { getByRole, getByTestId } = render(
    <FileButton accept=".json" testId="file" onFile={onFile}>
      Trazer
    </FileButton>,
  );
  const click = vi.spyOn(getByTestId("file"), "click");
  fireEvent.click(getByRole("button", { name: "Trazer" }));
  expect(click).not.toHaveBeenCalled();
  expect(driveRequest.value).toEqual({ kind: "open", suffix: ".json", onFile });
});
