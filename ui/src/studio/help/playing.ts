import { useEffect, useRef, useState } from "preact/hooks";
import { type Film, screenSeconds } from "./film";

/** As much of a film has to be in view before it plays. */
const IN_VIEW = 0.9;

/** Plays a film once when it comes into view, and again when asked; a still film shows its end. */
export function usePlaying(film: Film, isStill: boolean) {
  const [part, setPart] = useState(isStill ? 1 : 0);
  const place = useRef<HTMLButtonElement>(null);
  const request = useRef(0);
  const play = () => {
    cancelAnimationFrame(request.current);
    const begin = performance.now();
    const step = (now: number) => {
      const next = Math.min(1, Math.max(0, (now - begin) / (1000 * screenSeconds(film))));
      setPart(next);
      if (next < 1) request.current = requestAnimationFrame(step);
    };
    request.current = requestAnimationFrame(step);
  };
  useEffect(() => {
    if (isStill || !place.current) return;
    const seen = new IntersectionObserver(
      (entries) => {
        if (!entries.some(({ isIntersecting }) => isIntersecting)) return;
        seen.disconnect();
        play();
      },
      { threshold: IN_VIEW },
    );
    seen.observe(place.current);
    return () => {
      seen.disconnect();
      cancelAnimationFrame(request.current);
    };
  }, [film, isStill]);
  return { part, place, play };
}
