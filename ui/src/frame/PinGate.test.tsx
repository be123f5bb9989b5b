import { cleanup, fireEvent, render } from "@testing-library/preact";
import { afterEach, expect, test, vi } from "vitest";
import { ApiError } from "../api/errors";
import { passesAxe } from "../kit/testing/control";
import { asTeacher } from "../shell/teacher/teacher_session";
import { PinGate } from "./PinGate";

vi.stubGlobal(
  "fetch",
  vi.fn(async () => new Response(JSON.stringify({ has_pin: true, is_open: true }))),
);
afterEach(cleanup);

const refused = new ApiError(403, { code: "teacher_only", message: "", remedy: "" });

test("an action of the teacher waits for the PIN, and is done then", async () => {
  const work = vi.fn().mockRejectedValueOnce(refused).mockResolvedValue("opened");
  const { container, findByTestId, getByTestId, queryByTestId } = render(
    <PinGate>
      <p data-testid="screen">Grupos</p>
    </PinGate>,
  );
  expect(queryByTestId("pin")).toBeNull();
  const done = asTeacher(work);
  fireEvent.input(await findByTestId("pin"), { target: { value: "2718" } });
  expect(getByTestId("screen").closest("[hidden]")).not.toBeNull();
  await passesAxe(container);
  fireEvent.submit(getByTestId("pin").closest("form") as HTMLFormElement);
  expect(await done).toBe("opened");
  await vi.waitFor(() => expect(getByTestId("screen").closest("[hidden]")).toBeNull());
});

test("who goes back has not done it", async () => {
  const work = vi.fn().mockRejectedValue(refused);
  const { findByTestId, getByTestId, queryByTestId } = render(
    <PinGate>
      <p data-testid="screen">Grupos</p>
    </PinGate>,
  );
  void asTeacher(work);
  fireEvent.click(await findByTestId("sign-in-back"));
  await vi.waitFor(() => expect(queryByTestId("pin")).toBeNull());
  expect(getByTestId("screen").closest("[hidden]")).toBeNull();
  expect(work).toHaveBeenCalledOnce();
});
