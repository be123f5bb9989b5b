interface EmptyListProps {
  title: string;
  text: string;
  testId: string;
}

/** Stands where a screen of the review has nothing to list. */
export function EmptyList({ title, text, testId }: EmptyListProps) {
  return (
    <div class="review-empty" data-testid={testId}>
      <strong>{title}</strong>
      <p>{text}</p>
    </div>
  );
}
