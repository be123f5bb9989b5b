import { useState } from "preact/hooks";
import { type Problem, wordsOf } from "../app/session";
import { asTeacher } from "../app/teacher";

/** A form's way to the server: busy while it waits, and what went wrong, in words, beside it. */
export function useAct() {
  const [busy, setBusy] = useState(false);
  const [fault, setFault] = useState<Problem | null>(null);

  /** Whether it was done. */
  const act = async (work: () => Promise<unknown>): Promise<boolean> => {
    setBusy(true);
    setFault(null);
    try {
      await asTeacher(work);
      return true;
    } catch (error) {
      setFault(wordsOf(error));
      return false;
    } finally {
      setBusy(false);
    }
  };

  /** Says what the page itself finds wrong. */
  const refuse = (message: string) => setFault({ message, remedy: "" });

  return { busy, fault, act, refuse, clear: () => setFault(null) };
}
