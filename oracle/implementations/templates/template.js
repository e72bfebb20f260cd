// Answers entry asks, in doubles: node template.js. Copy it and put your own implementation in place of answer().
// A line comes in, a line goes out: hello, then scenes and asks. Not done here: clip, step, paint, and
// starts on a face that is left, which count as inside.

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const wholeLine = () => [{first: -Infinity, last: Infinity, leaf: null}];

// Where the line start + lambda * along runs in the shape, and the leaf by which it enters.
function spans(shape, start, along, leaves, material = null) {
  if (shape === 'everything') return wholeLine();
  if (shape === 'nothing') return [];
  if (shape.halfspace) {
    const normal = shape.halfspace.slice(0, 3);
    const leaf = {leaf: leaves.length, normal, material};
    leaves.push(leaf);
    const distance = dot(normal, start) - shape.halfspace[3];
    const slope = dot(normal, along);
    if (slope === 0) return distance <= 0 ? wholeLine() : [];
    const crossing = -distance / slope;
    return slope < 0 ? [{first: crossing, last: Infinity, leaf}] : [{first: -Infinity, last: crossing, leaf: null}];
  }
  if (shape.shape) return spans(shape.shape, start, along, leaves, material ?? shape.material);
  if (shape.intersection) {
    return shape.intersection.reduce((common, part) => {
      const others = spans(part, start, along, leaves, material);
      const pairs = common.flatMap(a => others.map(b => [a.first < b.first ? b : a, Math.min(a.last, b.last)]));
      return pairs.filter(([late, last]) => late.first <= last).map(([late, last]) => ({...late, last}));
    }, wholeLine());
  }
  const merged = [];
  const found = shape.union.flatMap(part => spans(part, start, along, leaves, material));
  for (const span of found.sort((a, b) => a.first < b.first ? -1 : a.first > b.first ? 1 : 0)) {
    const before = merged[merged.length - 1];
    if (before && span.first <= before.last) before.last = Math.max(before.last, span.last);
    else merged.push(span);
  }
  return merged;
}

function answer(shape, ask) {
  const [near, far] = ask.range;
  const along = ask.to.map((x, i) => x - ask.from[i]);
  const hit = spans(shape, ask.from, along, []).find(span => span.last >= near && span.first <= far);
  if (!hit) return {kind: 'miss'};
  return hit.first < near ? {kind: 'inside', lambda: near} : {kind: 'border', lambda: hit.first, ...hit.leaf};
}

let scene;
const say = object => console.log(JSON.stringify(object));
require('readline').createInterface({input: process.stdin}).on('line', text => {
  const line = JSON.parse(text);
  if (line.hello) say({hello: 'answers/1', name: 'template.js', asks: ['entry']});
  else if (line.scene) scene = line.scene;
  else say({id: line.id, answer: answer(scene.shape, line)});
});
