import { texts } from "../../i18n";
import type { Problem } from "./problem";
import { Unbroken } from "./Unbroken";

/** A message and what to do now. What only a technician can do, with its paths and options, opens with a click. */
export function ProblemText({ of: { message, remedy, details } }: { of: Problem }) {
  return (
    <>
      <strong>
        <Unbroken text={message} />
      </strong>{" "}
      <Unbroken text={remedy} />
      {details && (
        <details class="problem-details">
          <summary>{texts.value.trouble.details}</summary>
          <Unbroken text={details} />
        </details>
      )}
    </>
  );
}
