import { useEffect } from "preact/hooks";

/** Interval of looking how far the checking of runs has come. */
const LOOK_MS = 3000;

/** Looks again and again while runs of files wait to be checked. */
export function useProgress(isWaiting: boolean, look: () => unknown): void {
  useEffect(() => {
    if (!isWaiting) return;
    const timer = setInterval(() => {
      if (!document.hidden) look();
    }, LOOK_MS);
    return () => clearInterval(timer);
  }, [isWaiting]);
}
