import { useState } from "preact/hooks";
import { type Problem, problemOf } from "./problem";

type Work = () => Promise<unknown>;

/**
 * A form's request to the server, with its pending state and its error for display beside the form.
 * `through` wraps the request, for example `asTeacher`.
 */
export function useAction(through: (work: Work) => Promise<unknown> = (work) => work()) {
  const [busy, setBusy] = useState(false);
  const [fault, setFault] = useState<Problem | null>(null);

  /** Returns whether it succeeded. */
  const act = async (work: Work): Promise<boolean> => {
    setBusy(true);
    setFault(null);
    try {
      await through(work);
      return true;
    } catch (error) {
      setFault(problemOf(error));
      return false;
    } finally {
      setBusy(false);
    }
  };

  /** Shows an error found by the page. */
  const refuse = (message: string) => setFault({ message, remedy: "" });

  return { busy, fault, act, refuse, clear: () => setFault(null) };
}
