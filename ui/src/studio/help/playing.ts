import { useEffect, useRef, useState } from "preact/hooks";
import { type BlockAnimation, screenSeconds } from "./animation";

/** Visible fraction of an animation at which it starts to play. */
const IN_VIEW = 0.9;

/** Plays an animation once when it comes into view, and again on request; if `isStill`, shows its end. */
export function usePlaying(animation: BlockAnimation, isStill: boolean) {
  const [part, setPart] = useState(isStill ? 1 : 0);
  const place = useRef<HTMLButtonElement>(null);
  const request = useRef(0);
  const play = () => {
    cancelAnimationFrame(request.current);
    const begin = performance.now();
    const step = (now: number) => {
      const next = Math.min(1, Math.max(0, (now - begin) / (1000 * screenSeconds(animation))));
      setPart(next);
      if (next < 1) request.current = requestAnimationFrame(step);
    };
    request.current = requestAnimationFrame(step);
  };
  useEffect(() => {
    if (isStill || !place.current) return;
    const observer = new IntersectionObserver(
      (entries) => {
        if (!entries.some(({ isIntersecting }) => isIntersecting)) return;
        observer.disconnect();
        play();
      },
      { threshold: IN_VIEW },
    );
    observer.observe(place.current);
    return () => {
      observer.disconnect();
      cancelAnimationFrame(request.current);
    };
  }, [animation, isStill]);
  return { part, place, play };
}
