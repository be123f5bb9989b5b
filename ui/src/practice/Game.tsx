import { CircleCheck, Hand, RotateCcw, SkipForward } from "lucide-preact";
import { useLayoutEffect, useState } from "preact/hooks";
import { drawnHand } from "../camera/drawn_hand";
import { SignDrawing } from "../camera/SignDrawing";
import { listenForSigns } from "../camera/signs";
import { texts } from "../i18n";
import { namedSign } from "../i18n/phrases";
import { Button } from "../kit/Button";
import type { Spelling } from "./spelling";
import { drawTargets, N_TARGETS, type RoundOutcome, SpellingGame } from "./spelling_game";

const newRound = () => new SpellingGame(drawTargets(texts.peek().game.words.split(" ")));

/** Rounds of words: each letter is made with a sign, or with its key. */
export function Game({ spelling }: { spelling: Spelling }) {
  const [game, setGame] = useState(newRound);
  useLayoutEffect(() => {
    const receive = (sign: string) => game.receive(sign);
    spelling.onSign = receive;
    const stop = listenForSigns(receive);
    return () => {
      spelling.onSign = null;
      stop();
    };
  }, [game, spelling]);
  const { current } = game;
  return (
    <section class="game card column grows shrinks-down gap-3" aria-label={texts.value.game.title}>
      {current.value === null ? (
        <Outcome outcome={game.outcome} onAgain={() => setGame(newRound)} />
      ) : (
        <Target game={game} target={current.value} />
      )}
    </section>
  );
}

function Target({ game, target }: { game: SpellingGame; target: string }) {
  const labels = texts.value.game;
  const next = game.next.value;
  return (
    <>
      <h2 class="game__title">{labels.number({ n: game.number, of: N_TARGETS })}</h2>
      <p class="game__word row center gap-2" aria-label={target} role="img" data-testid="game-word">
        {[...target].map((letter, index) => (
          <span
            key={`${index} ${letter}`}
            class="game__letter"
            data-state={stateOf(index, game.nSpelled.value)}
          >
            {letter}
          </span>
        ))}
      </p>
      <div class="game__hint column grows shrinks-down middle center">
        {game.isHinted.value && next && <SignDrawing sign={next} hand={drawnHand.value} />}
      </div>
      <p class="game__next" role="status">
        {next && <Next letter={next} other={game.other.value} />}
      </p>
      <div class="row wrap gap-2">
        <Button icon={Hand} testId="game-hint" onPress={() => game.hint()}>
          {labels.hint}
        </Button>
        <Button kind="plain" icon={SkipForward} testId="game-skip" onPress={() => game.skip()}>
          {labels.skip}
        </Button>
      </div>
    </>
  );
}

const stateOf = (index: number, nSpelled: number) =>
  index < nSpelled ? "spelled" : index === nSpelled ? "next" : "open";

function Next({ letter, other }: { letter: string; other: string | null }) {
  const sign = (name: string) => namedSign(name, texts.value);
  if (other === null) return texts.value.game.next({ sign: sign(letter) });
  return texts.value.practice.other({ shown: sign(other), sign: sign(letter) });
}

/** What went well in the round, and which letters to make again. */
function Outcome({ outcome, onAgain }: { outcome: RoundOutcome; onAgain(): void }) {
  const { game } = texts.value;
  const { spelled, alone, hinted } = outcome;
  return (
    <div class="column gap-3" role="status" data-testid="game-outcome">
      <h2 class="game__title row middle gap-2">
        <CircleCheck class="icon" aria-hidden="true" />
        {spelled.length > 0 ? game.done : game.over}
      </h2>
      {spelled.length > 0 && <p>{game.spelled({ words: spelled.join(", ") })}</p>}
      {alone.length > 0 && <p>{game.alone({ letters: alone.join(", ") })}</p>}
      {hinted.length > 0 && <p>{game.hinted({ letters: hinted.join(", ") })}</p>}
      <div class="row">
        <Button kind="main" icon={RotateCcw} testId="game-again" onPress={onAgain}>
          {game.again}
        </Button>
      </div>
    </div>
  );
}
