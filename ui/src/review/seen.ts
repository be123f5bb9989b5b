import { type ReadonlySignal, useSignal } from "@preact/signals";
import { useCallback, useEffect, useRef } from "preact/hooks";
import { report } from "../app/session";
import { asTeacher, isShut } from "../app/teacher";

/** What the server said, and when. */
export interface Seen<T> {
  readonly what: T;
  readonly at: Date;
}

interface Watched<T> {
  readonly seen: ReadonlySignal<Seen<T> | null>;
  readonly busy: ReadonlySignal<boolean>;
  readonly failed: ReadonlySignal<boolean>;
  again(): void;
}

/**
 * What only a teacher may see, asked for now, when it is asked for `again`, and when the window is come back to; then
 * a door that has shut stays shut: what is seen needs no PIN to stay. `key`: what it is about.
 */
export function useSeen<T>(key: unknown, ask: () => Promise<T>): Watched<T> {
  const seen = useSignal<Seen<T> | null>(null);
  const busy = useSignal(false);
  const failed = useSignal(false);
  const turn = useRef(0);
  const asked = useRef(ask);
  asked.current = ask;

  const look = useCallback((work: () => Promise<T>, onFault: (error: unknown) => void) => {
    const mine = ++turn.current;
    const at = new Date();
    busy.value = true;
    work().then(
      (what) => {
        if (mine !== turn.current) return;
        seen.value = { what, at };
        busy.value = false;
      },
      (error) => {
        if (mine !== turn.current) return;
        busy.value = false;
        onFault(error);
      },
    );
  }, []);
  const again = useCallback(() => look(() => asTeacher(asked.current), report), []);
  useEffect(() => {
    look(
      () => asTeacher(asked.current),
      (error) => {
        failed.value = seen.peek() === null;
        report(error);
      },
    );
    return () => {
      turn.current++;
    };
  }, [key]);
  const comeBack = useCallback(() => {
    if (busy.peek() || !seen.peek()) return;
    look(asked.current, (error) => {
      if (!isShut(error)) report(error);
    });
  }, []);
  useEffect(() => {
    addEventListener("focus", comeBack);
    return () => removeEventListener("focus", comeBack);
  }, []);
  return { seen, busy, failed, again };
}
