import { cleanup, fireEvent, render } from "@testing-library/preact";
import { afterEach, beforeAll, beforeEach, expect, test, vi } from "vitest";
import { fetchLazyTexts, texts } from "../i18n";
import { passesAxe } from "../kit/testing/control";
import { driveRequest } from "../shell/files/drive_request";
import { DriveDialog } from "./DriveDialog";

const FILE = {
  path: "/media/ana/PINEL/tatu.pinel",
  name: "tatu.pinel",
  size_bytes: 20_000,
  modified_at: "2026-11-01T10:00:00Z",
};
const STICK = {
  path: "/media/ana/PINEL",
  name: "PINEL",
  is_removable: true,
  is_writable: true,
  files: [FILE],
};

/** Answers of the server by method and path; a number is an error's status. */
let answers: Record<string, unknown>;
const fetched = vi.fn(async (request: Request) => {
  const { pathname } = new URL(request.url);
  const answer = answers[`${request.method} ${pathname}`];
  if (typeof answer !== "number") return new Response(JSON.stringify(answer));
  const error = { code: "export_failed", message: "O pendrive saiu.", remedy: "Conecte-o." };
  return new Response(JSON.stringify({ error }), { status: answer });
});
vi.stubGlobal("fetch", fetched);

beforeAll(async () => {
  HTMLDialogElement.prototype.showModal ??= function showModal() {
    this.setAttribute("open", "");
  };
  await fetchLazyTexts();
});
beforeEach(() => {
  fetched.mockClear();
  answers = { "GET /api/drives": { drives: [STICK] } };
});
afterEach(() => {
  cleanup();
  driveRequest.value = null;
});

test("a file of a stick is handed over under its name, and the dialog closes", async () => {
  const onFile = vi.fn();
  driveRequest.value = { kind: "open", suffix: ".pinel", onFile };
  answers["GET /api/drives/file"] = "octets";
  const { container, findByTestId, queryByTestId } = render(<DriveDialog />);
  fireEvent.click(await findByTestId("drive-file"));
  await vi.waitFor(() => expect(onFile).toHaveBeenCalledOnce());
  expect(onFile.mock.calls[0]?.[0].name).toBe("tatu.pinel");
  expect(queryByTestId("drives")).toBeNull();
  await passesAxe(container);
});

test("what is saved gets the name that the server gave it", async () => {
  driveRequest.value = { kind: "save", name: "mundo.json", content: new Blob(["{}"]) };
  answers["POST /api/drives/file"] = {
    name: "mundo (2).json",
    drive: "PINEL",
    is_removable: true,
  };
  const { container, findByTestId, findByText } = render(<DriveDialog />);
  fireEvent.click(await findByTestId("drive-save"));
  await findByText(/mundo \(2\)\.json/);
  await passesAxe(container);
});

test("an error stands in the dialog, and saving can be tried again", async () => {
  driveRequest.value = { kind: "save", name: "mundo.json", content: new Blob(["{}"]) };
  answers["POST /api/drives/file"] = 422;
  const { findByTestId, findByText, findByRole } = render(<DriveDialog />);
  fireEvent.click(await findByTestId("drive-save"));
  expect((await findByRole("alert")).textContent).toContain("O pendrive saiu.");
  answers["POST /api/drives/file"] = { name: "mundo.json", drive: "PINEL", is_removable: false };
  fireEvent.click(await findByTestId("drive-save"));
  await findByText(/mundo\.json.*PINEL|PINEL.*mundo\.json/);
});

test("without a stick it says so, and looks again", async () => {
  driveRequest.value = { kind: "open", suffix: ".pinel", onFile: vi.fn() };
  answers["GET /api/drives"] = { drives: [] };
  const { container, findByText, getByTestId, findByTestId } = render(<DriveDialog />);
  await findByText(texts.value.kiosk.nowhereHint);
  await passesAxe(container);
  answers["GET /api/drives"] = { drives: [STICK] };
  fireEvent.click(getByTestId("drives-again"));
  await findByTestId("drive-file");
});
