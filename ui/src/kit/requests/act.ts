import { useState } from "preact/hooks";
import { type Problem, wordsOf } from "./problem";

type Work = () => Promise<unknown>;

/**
 * A form's request to the server: busy while it waits, and its failure in words beside the form.
 * `through`: how the work is done where it needs more than to be called, for example `asTeacher`.
 */
export function useAct(through: (work: Work) => Promise<unknown> = (work) => work()) {
  const [busy, setBusy] = useState(false);
  const [fault, setFault] = useState<Problem | null>(null);

  /** Whether it was done. */
  const act = async (work: Work): Promise<boolean> => {
    setBusy(true);
    setFault(null);
    try {
      await through(work);
      return true;
    } catch (error) {
      setFault(wordsOf(error));
      return false;
    } finally {
      setBusy(false);
    }
  };

  /** Shows what the page itself finds wrong. */
  const refuse = (message: string) => setFault({ message, remedy: "" });

  return { busy, fault, act, refuse, clear: () => setFault(null) };
}
