import type { Ref } from "preact";
import { useLayoutEffect, useRef } from "preact/hooks";
import { SignDrawing } from "../../camera/SignDrawing";
import type { BlockCard, BlockCards } from "../../editor/block_cards";
import { language, texts } from "../../i18n";
import { Loaded } from "../../kit/requests/Loaded";
import { useLoaded } from "../../kit/requests/useLoaded";
import { blockCards, type CardList, LESSON_LETTERS } from "./card_lists";

interface CardSheetProps {
  list: CardList;
  copies: number;
  ink: "lines" | "colours";
  elementRef: Ref<HTMLElement>;
}

/** The printed sheet: `copies` of each card, with lines to cut along. */
export function CardSheet({ list, copies, ink, elementRef }: CardSheetProps) {
  const labels = texts.value.plan.cards;
  return (
    <section
      class="cards"
      aria-label={labels.sheet}
      ref={elementRef}
      data-ink={ink}
      data-list={list}
      data-testid="cards"
    >
      {list === "letters" ? (
        <LetterCards copies={copies} />
      ) : (
        <DrawnCards list={list} copies={copies} />
      )}
    </section>
  );
}

function LetterCards({ copies }: Pick<CardSheetProps, "copies">) {
  return (
    <ul class="card-sheet card-sheet--letters">
      {LESSON_LETTERS.flatMap((letter) =>
        times(copies).map((n) => (
          <li key={`${letter}${n}`} class="card-cut" data-testid="card" data-name={letter}>
            <SignDrawing sign={letter} class="card-letter" />
            <b>{letter}</b>
          </li>
        )),
      )}
    </ul>
  );
}

interface DrawnCardsProps {
  list: Exclude<CardList, "letters">;
  copies: number;
}

function DrawnCards({ list, copies }: DrawnCardsProps) {
  const { plan } = texts.value;
  const found = useLoaded(`${list} ${language.value}`, () => blockCards(list, language.value));
  return (
    <Loaded of={found} loading={plan.cards.drawing}>
      {({ cards, stageClasses }: BlockCards) => (
        <ul class="card-sheet">
          {cards.flatMap((card) =>
            times(copies).map((n) => (
              <li
                key={`${card.name}${n}`}
                class="card-cut"
                data-testid="card"
                data-name={card.name}
              >
                <Card card={card} stageClasses={stageClasses} />
              </li>
            )),
          )}
        </ul>
      )}
    </Loaded>
  );
}

interface CardProps {
  card: BlockCard;
  stageClasses: string;
}

function Card({ card, stageClasses }: CardProps) {
  const picture = useRef<HTMLDivElement>(null);
  useLayoutEffect(() => picture.current?.replaceChildren(card.svg.cloneNode(true)), [card]);
  return (
    <div ref={picture} role="img" aria-label={card.text} class={`card-block ${stageClasses}`} />
  );
}

const times = (n: number) => Array.from({ length: n }, (_, index) => index);
