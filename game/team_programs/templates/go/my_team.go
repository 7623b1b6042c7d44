// A team of one page. Robot 0 stays in the goal, the robot nearest to the ball gets behind it and
// kicks it to the opponents' goal, and the others stand in a row. Our goal is at -x.
//
// It reads one JSON object per line and answers each frame with one line. Anything else, such as
// debugging output, belongs on os.Stderr. Every number is in metres and seconds.
package main

import (
	"encoding/json"
	"fmt"
	"log"
	"math"
	"os"
)

const (
	speedMps  float64 = 2.0 // of all robots
	stopMps   float64 = 0.9 // while play is stopped: the Laws of 2014 allow 1 m/s
	turnRadps float64 = 8.0
	kickMps   float64 = 5.0

	// Distance to the ball or its path while we may not play it: the rules require 0.5 m to the hull.
	tooNearM float64 = 0.6
	keepOffM float64 = 0.65 // the distance to which robots retreat
)

type Field struct {
	Length       float64 `json:"length_m"`
	Width        float64 `json:"width_m"`
	AreaDepth    float64 `json:"defence_area_depth_m"`
	AreaStraight float64 `json:"defence_area_straight_m"`
	AreaIsBox    bool    `json:"defence_area_is_box"`
}

type Start struct {
	Field Field `json:"field"`
}

type Ball struct {
	X  float64 `json:"x_m"`
	Y  float64 `json:"y_m"`
	Vx float64 `json:"vx_mps"`
	Vy float64 `json:"vy_mps"`
}

type Robot struct {
	Number   int     `json:"number"`
	X        float64 `json:"x_m"`
	Y        float64 `json:"y_m"`
	HeadingX float64 `json:"heading_x"`
	HeadingY float64 `json:"heading_y"`
	Vx       float64 `json:"vx_mps"`
	Vy       float64 `json:"vy_mps"`
}

type Frame struct {
	Number     int64    `json:"frame"`
	Latency    float64  `json:"latency_s"`
	Play       string   `json:"play"`
	Ours       bool     `json:"ours"`
	PlacementX *float64 `json:"placement_x_m"` // the referee's target for the ball, if any
	PlacementY *float64 `json:"placement_y_m"`
	Ball       Ball     `json:"ball"`
	Own        []Robot  `json:"own"`
}

// A message to us: START, FRAME or END.
type Input struct {
	Start *Start `json:"start"`
	Frame *Frame `json:"frame"`
}

type Command struct {
	Robot int     `json:"robot"`
	Vx    float64 `json:"vx_mps"` // forward
	Vy    float64 `json:"vy_mps"` // to its left
	Turn  float64 `json:"angular_velocity_radps"`
	Kick  float64 `json:"kick_mps"` // takes effect as soon as the ball is at the kicker
}

type Output struct {
	Frame    int64     `json:"frame"`
	Keeper   int       `json:"keeper"`
	Commands []Command `json:"commands"`
}

type Point struct{ x, y float64 }

func main() {
	fmt.Println("autoref-team 1 json")
	input, output := json.NewDecoder(os.Stdin), json.NewEncoder(os.Stdout)
	var field Field
	for {
		var message Input
		if err := input.Decode(&message); err != nil {
			log.Fatal(err)
		}
		if message.Start != nil {
			field = message.Start.Field
		} else if message.Frame == nil {
			return // the game has ended
		} else if err := output.Encode(decide(*message.Frame, field)); err != nil {
			log.Fatal(err)
		}
	}
}

func decide(frame Frame, field Field) Output {
	output := Output{Frame: frame.Number, Commands: []Command{}}
	if frame.Play == "HALT" || len(frame.Own) == 0 {
		return output
	}
	latency := frame.Latency // our commands take effect this much later
	ball := Point{frame.Ball.X + frame.Ball.Vx*latency, frame.Ball.Y + frame.Ball.Vy*latency}
	isOurs := frame.Play == "RUNNING" || (frame.Ours && isPlayable(frame.Play))
	most := speedMps
	if frame.Play == "STOP" {
		most = stopMps
	}
	chaser := 0 // the keeper if the ball is in our area, otherwise another robot
	if !isInArea(field, -ball.x, ball.y, 0) {
		chaser = nearest(frame.Own, ball)
	}
	for index, robot := range frame.Own {
		at, to := lineUp(float64(index), float64(len(frame.Own)), ball, field)
		if isOurs && index == chaser {
			at, to = attack(robot, ball, field)
		} else if index == 0 {
			at, to = guard(ball, field)
		}
		if index != 0 {
			at.x = outOfAreas(field, at.x, at.y)
		}
		if !isOurs {
			at = keepOff(robot, at, nearestOnWay(robot, ball, frame))
		}
		output.Commands = append(output.Commands, drive(robot, at, to, most, latency))
	}
	output.Keeper = frame.Own[0].Number
	return output
}

// Whether the team that takes the restart may play the ball.
func isPlayable(play string) bool {
	return play == "KICKOFF" || play == "PENALTY" || play == "DIRECT_FREE" || play == "INDIRECT_FREE"
}

// The index of the robot nearest to the ball, except the keeper.
func nearest(own []Robot, ball Point) int {
	best, least := len(own), math.Inf(1)
	for index := 1; index < len(own); index++ {
		dx, dy := own[index].X-ball.x, own[index].Y-ball.y
		if dx*dx+dy*dy < least {
			best, least = index, dx*dx+dy*dy
		}
	}
	return best
}

// Drives through the ball towards the goal, or first to a place behind the ball, or around it. Like
// the next two, it returns the robot's destination and the direction to face.
func attack(robot Robot, ball Point, field Field) (Point, Point) {
	to := unit(field.Length/2-ball.x, -ball.y)
	dx, dy := robot.X-ball.x, robot.Y-ball.y
	ahead, aside := dx*to.x+dy*to.y, dy*to.x-dx*to.y
	back, off := 0.2, -0.25
	if ahead < -0.05 && -0.04 < aside && aside < 0.04 {
		back, off = -0.05, 0
	} else if ahead < -0.12 {
		back, off = 0.15, 0
	} else if aside > 0 {
		off = 0.25
	}
	return Point{ball.x - back*to.x - off*to.y, ball.y - back*to.y + off*to.x}, to
}

// Stands on the line from the ball to the middle of our goal.
func guard(ball Point, field Field) (Point, Point) {
	goalX := -field.Length / 2
	to := unit(ball.x-goalX, ball.y)
	return Point{goalX + 0.1 + 0.2*to.x, 0.3 * to.y}, to
}

// Stands in a row across our half, facing the ball.
func lineUp(index, count float64, ball Point, field Field) (Point, Point) {
	at := Point{-field.Length / 5, (index - count/2) * field.Width / (count + 1)}
	return at, unit(ball.x-at.x, ball.y-at.y)
}

// Whether a point is in the opponents' defence area, approximated by a box; for ours, pass -x.
func isInArea(field Field, x, y, margin float64) bool {
	half := field.AreaStraight / 2
	if !field.AreaIsBox {
		half = half + field.AreaDepth
	}
	depth := field.AreaDepth + margin
	return x > field.Length/2-depth && -half-margin < y && y < half+margin
}

// The nearest x at which a robot is in neither defence area.
func outOfAreas(field Field, x, y float64) float64 {
	limit := field.Length/2 - field.AreaDepth - 0.3
	if isInArea(field, x, y, 0.3) {
		return limit
	}
	if isInArea(field, -x, y, 0.3) {
		return -limit
	}
	return x
}

// The point nearest to the robot on the ball's path to the referee's target.
func nearestOnWay(robot Robot, ball Point, frame Frame) Point {
	if frame.PlacementX == nil || frame.PlacementY == nil {
		return ball
	}
	end := Point{*frame.PlacementX, *frame.PlacementY}
	way := Point{end.x - ball.x, end.y - ball.y}
	whole := way.x*way.x + way.y*way.y
	along := (robot.X-ball.x)*way.x + (robot.Y-ball.y)*way.y
	if along <= 0 {
		return ball
	}
	if along >= whole {
		return end
	}
	return Point{ball.x + along/whole*way.x, ball.y + along/whole*way.y}
}

// Moves away from a point if the robot is near it; otherwise goes to the place, but around the
// point.
func keepOff(robot Robot, place, point Point) Point {
	dx, dy := robot.X-point.x, robot.Y-point.y
	if dx*dx+dy*dy < tooNearM*tooNearM {
		place = Point{robot.X, robot.Y}
	}
	from := unit(dx, dy)
	lack := keepOffM - (place.x-point.x)*from.x - (place.y-point.y)*from.y
	if lack > 0 {
		place = Point{place.x + lack*from.x, place.y + lack*from.y}
	}
	return place
}

// A command that brings the robot to a point, facing a direction.
func drive(robot Robot, at, to Point, most, latency float64) Command {
	vx := 3 * (at.x - robot.X - robot.Vx*latency)
	vy := 3 * (at.y - robot.Y - robot.Vy*latency)
	speed := math.Sqrt(vx*vx + vy*vy)
	if speed > most {
		vx, vy = vx/speed*most, vy/speed*most
	}
	frontX, frontY := robot.HeadingX, robot.HeadingY
	turn := frontX*to.y - frontY*to.x // the sine of the angle to turn by
	if frontX*to.x+frontY*to.y < 0 {
		if turn > 0 {
			turn = 1
		} else {
			turn = -1
		}
	}
	return Command{robot.Number, vx*frontX + vy*frontY, vy*frontX - vx*frontY, turnRadps * turn, kickMps}
}

func unit(x, y float64) Point {
	length := math.Sqrt(x*x + y*y)
	if length > 0 {
		return Point{x / length, y / length}
	}
	return Point{1, 0}
}
